#include "harness/core/loads.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <variant>

namespace cylon::core {
namespace {

std::size_t at(int body) { return static_cast<std::size_t>(body); }

// A point of a body, or of the world, and what its place and velocity are off by.
struct Point {
  Vector3 arm = Vector3::Zero(), position = Vector3::Zero(), velocity = Vector3::Zero();
  double off = 0, velocity_off = 0;
};

struct Laws {
  const Scene& scene;
  double t;
  const State& state;
  const StateError& error;
  std::vector<Load>& loads;

  // |dx| <= |dx_c| + |r| |dtheta|,  |dv| <= |dv_c| + |r| |dw| + |w| |r| |dtheta|
  Point point(int body, const Vector3& anchor) const {
    if (body == world) return {.position = anchor};
    const BodyState& s = state[at(body)];
    const Vector3 arm = s.orientation * anchor;
    const double r = arm.norm();
    return {arm, s.position + arm, s.velocity + s.angular_velocity.cross(arm),
            error.position + r * error.orientation,
            error.velocity + r * (error.angular_velocity + s.angular_velocity.norm() * error.orientation)};
  }

  void push(int body, const Vector3& arm, const Vector3& force, double off) const {
    if (body == world) return;
    Load& load = loads[at(body)];
    load.force += force, load.force_error += off;
    load.torque += arm.cross(force);
    load.torque_error += arm.norm() * (off + force.norm() * error.orientation);
  }

  void operator()(const UniformGravity&) const {}  // with the bodies' own

  // F = p u,  p = k (|d| - L) + c |d|',  u = d/|d|:   |dF| <= k |dd| + c (|dd'| + |d'| |dd|/|d|) + |p| |dd|/|d|
  void operator()(const Spring& spring) const {
    const Point a = point(spring.body, spring.anchor), b = point(spring.to, spring.to_anchor);
    const Vector3 d = b.position - a.position, rate = b.velocity - a.velocity;
    const double length = d.norm(), off = a.off + b.off, rate_off = a.velocity_off + b.velocity_off;
    if (length == 0) {
      const bool jumps = spring.rest_length > 0 || spring.damping > 0;
      const double lost = jumps ? std::numeric_limits<double>::infinity() : spring.stiffness * off;
      push(spring.body, a.arm, Vector3::Zero(), lost);
      push(spring.to, b.arm, Vector3::Zero(), lost);
      return;
    }
    const double pull =
        spring.stiffness * (length - spring.rest_length) + spring.damping * rate.dot(d) / length;
    const double lost = spring.stiffness * off + spring.damping * (rate_off + rate.norm() * off / length) +
                        std::abs(pull) * off / length;
    push(spring.body, a.arm, pull / length * d, lost);
    push(spring.to, b.arm, -pull / length * d, lost);
  }

  // F = -linear v,  torque = -angular w - momentum L_spin,  |dL_spin| <= I (|dw| + 2 |w| |dtheta|)
  void operator()(const Drag& drag) const {
    const Body& body = scene.bodies[at(drag.body)];
    const BodyState& s = state[at(drag.body)];
    Load& load = loads[at(drag.body)];
    load.force -= drag.linear * s.velocity, load.force_error += drag.linear * error.velocity;
    load.torque -= drag.angular * s.angular_velocity;
    load.torque -= drag.momentum * (world_inertia(body, s.orientation) * s.angular_velocity);
    load.torque_error += drag.angular * error.angular_velocity;
    load.torque_error += drag.momentum * largest_moment(body) *
                         (error.angular_velocity + 2 * s.angular_velocity.norm() * error.orientation);
  }

  // A force that is fixed in the body.
  void operator()(const Thrust& thrust) const {
    const Vector3 force = state[at(thrust.body)].orientation * thrust.force;
    push(thrust.body, Vector3::Zero(), force, force.norm() * error.orientation);
  }

  void operator()(const Drive& drive) const {
    push(drive.body, Vector3::Zero(), drive.force * std::cos(drive.frequency * t), 0);
  }

  // F = s m_a m_b d/|d|^3,  |dF| <= 3 |F| |dd|/|d|
  void operator()(const Attraction& pull) const {
    const Point a = point(pull.body, Vector3::Zero()), b = point(pull.to, Vector3::Zero());
    const Vector3 d = b.position - a.position;
    const double length = d.norm(),
                 masses = scene.bodies[at(pull.body)].mass * scene.bodies[at(pull.to)].mass;
    const Vector3 force = pull.strength * masses / (length * length * length) * d;
    const double lost = 3 * force.norm() * (a.off + b.off) / length;
    push(pull.body, Vector3::Zero(), force, lost);
    push(pull.to, Vector3::Zero(), -force, lost);
  }

  [[noreturn]] void operator()(const Water&) const { throw std::logic_error("water has no known load"); }
  [[noreturn]] void operator()(const PluginForce&) const {
    throw std::logic_error("a plug-in's force has no known load");
  }
};

}  // namespace

double largest_moment(const Body& body) { return principal_axes(body.inertia).moments.maxCoeff(); }

std::optional<std::string> loads_unknown(const Scene& scene) {
  if (has_fictitious_forces(scene)) return "the scene's frame turns or accelerates";
  for (const Force& force : scene.forces) {
    if (std::holds_alternative<Water>(force)) return "water acts in the scene";
    if (std::holds_alternative<PluginForce>(force)) return "a plug-in's force acts, which is not known";
    const auto* thrust = std::get_if<Thrust>(&force);
    if (thrust && thrust->mass_rate != 0) return "the mass of a body changes";
  }
  return std::nullopt;
}

std::vector<Load> loads(const Scene& scene, double t, const State& state, const StateError& error) {
  std::vector<Load> result(state.size());
  for (std::size_t i = 0; i < state.size(); ++i)
    result[i].force = scene.bodies[i].mass * gravity_of(scene, scene.bodies[i]);
  const Laws laws{scene, t, state, error, result};
  for (const Force& force : scene.forces) std::visit(laws, force);
  return result;
}

}  // namespace cylon::core
