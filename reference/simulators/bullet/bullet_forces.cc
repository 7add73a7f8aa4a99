#include "reference/simulators/bullet/bullet_forces.h"

#include <algorithm>
#include <cmath>

namespace cylon::simulators {
namespace {

using core::Vector3;

std::size_t index(int body) { return static_cast<std::size_t>(body); }

struct Evaluate {
  const core::Scene& scene;
  const core::State& state;
  double t;
  std::vector<Wrench>& wrenches;

  // A point of a body, or of the world, and its velocity.
  struct Point {
    Vector3 arm, position, velocity;
  };
  Point point(int body, const Vector3& anchor) const {
    if (body == core::world) return {Vector3::Zero(), anchor, Vector3::Zero()};
    const core::BodyState& s = state[index(body)];
    const Vector3 arm = s.orientation * anchor;
    return {arm, s.position + arm, s.velocity + s.angular_velocity.cross(arm)};
  }
  void push(int body, const Vector3& arm, const Vector3& force) const {
    if (body == core::world) return;
    wrenches[index(body)].force += force;
    wrenches[index(body)].torque += arm.cross(force);
  }

  void operator()(const core::UniformGravity&) const {}  // the engine's own

  // F = (k (|d| - L) + c d|d|/dt) d/|d|
  void operator()(const core::Spring& spring) const {
    const Point a = point(spring.body, spring.anchor), b = point(spring.to, spring.to_anchor);
    const Vector3 d = b.position - a.position;
    const double length = d.norm();
    if (length == 0) return;
    const double rate = (b.velocity - a.velocity).dot(d) / length;
    const double pull = spring.stiffness * (length - spring.rest_length) + spring.damping * rate;
    const Vector3 force = pull * d / length;
    push(spring.body, a.arm, force);
    push(spring.to, b.arm, -force);
  }

  // F = -linear v; torque = -angular w - momentum R I R^T w
  void operator()(const core::Drag& drag) const {
    const core::BodyState& s = state[index(drag.body)];
    Wrench& w = wrenches[index(drag.body)];
    w.force -= drag.linear * s.velocity;
    w.torque -= drag.angular * s.angular_velocity;
    if (drag.momentum != 0)
      w.torque -=
          drag.momentum * (world_inertia(scene.bodies[index(drag.body)], s.orientation) * s.angular_velocity);
  }

  void operator()(const core::Thrust& thrust) const {
    wrenches[index(thrust.body)].force += state[index(thrust.body)].orientation * thrust.force;
  }

  void operator()(const core::Drive& drive) const {
    wrenches[index(drive.body)].force += drive.force * std::cos(drive.frequency * t);
  }

  // F = strength m_a m_b d/|d|^3
  void operator()(const core::Attraction& attraction) const {
    const Vector3 d = state[index(attraction.to)].position - state[index(attraction.body)].position;
    const double length = d.norm();
    const double masses = scene.bodies[index(attraction.body)].mass * scene.bodies[index(attraction.to)].mass;
    const Vector3 force = attraction.strength * masses / (length * length * length) * d;
    push(attraction.body, Vector3::Zero(), force);
    push(attraction.to, Vector3::Zero(), -force);
  }

  void operator()(const core::Water&) const {}  // inexpressible
};

struct Reason {
  std::optional<std::string> operator()(const core::Thrust& thrust) const {
    if (thrust.mass_rate == 0) return std::nullopt;
    return "Bullet has no changing mass (thrust with mass_rate).";
  }
  std::optional<std::string> operator()(const core::Water&) const { return "Bullet has no water."; }
  std::optional<std::string> operator()(const core::UniformGravity&) const { return std::nullopt; }
  std::optional<std::string> operator()(const core::Spring&) const { return std::nullopt; }
  std::optional<std::string> operator()(const core::Drag&) const { return std::nullopt; }
  std::optional<std::string> operator()(const core::Drive&) const { return std::nullopt; }
  std::optional<std::string> operator()(const core::Attraction&) const { return std::nullopt; }
};

}  // namespace

std::optional<std::string> inexpressible(const core::Force& force) { return std::visit(Reason{}, force); }

core::Vector3 gravity(const core::Scene& scene) {
  Vector3 sum = Vector3::Zero();
  for (const core::Force& force : scene.forces)
    if (const auto* g = std::get_if<core::UniformGravity>(&force)) sum += g->acceleration;
  return sum;
}

bool has_applied_forces(const core::Scene& scene) {
  return std::any_of(scene.forces.begin(), scene.forces.end(), [](const core::Force& force) {
    return !std::holds_alternative<core::UniformGravity>(force);
  });
}

void applied_forces(const core::Scene& scene, const core::State& state, double t,
                    std::vector<Wrench>& wrenches) {
  wrenches.assign(scene.bodies.size(), {});
  for (const core::Force& force : scene.forces) std::visit(Evaluate{scene, state, t, wrenches}, force);
}

}  // namespace cylon::simulators
