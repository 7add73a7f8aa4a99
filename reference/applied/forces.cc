#include "reference/applied/forces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cylon::applied {
namespace {

using core::Vector3;

std::size_t index(int body) { return static_cast<std::size_t>(body); }

// ---- The laws, one per kind of force ----------------------------------------------------------------

struct Law {
  const core::Scene& scene;
  const core::State& state;
  const std::vector<std::optional<Immersion>>& immersions;
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
  core::Matrix3 inertia(std::size_t i) const {
    return core::world_inertia(scene.bodies[i], state[i].orientation);
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

  // F = -linear v;  torque = -angular w - momentum I w
  void operator()(const core::Drag& drag) const {
    const std::size_t i = index(drag.body);
    const core::BodyState& s = state[i];
    wrenches[i].force -= drag.linear * s.velocity;
    wrenches[i].torque -= drag.angular * s.angular_velocity;
    if (drag.momentum != 0) wrenches[i].torque -= drag.momentum * (inertia(i) * s.angular_velocity);
  }

  // F = R force + dm/dt c  with c the velocity of the exchanged mass relative to the body:  from
  // d(m v)/dt = dm/dt (v + c).
  void operator()(const core::Thrust& thrust) const {
    const core::BodyState& s = state[index(thrust.body)];
    Vector3 relative = Vector3::Zero();
    if (thrust.exhaust_velocity) relative = s.orientation * *thrust.exhaust_velocity;
    if (thrust.exchanged_velocity) relative = *thrust.exchanged_velocity - s.velocity;
    push(thrust.body, Vector3::Zero(), s.orientation * thrust.force + thrust.mass_rate * relative);
  }

  // F = force cos(frequency t)
  void operator()(const core::Drive& drive) const {
    push(drive.body, Vector3::Zero(), drive.force * std::cos(drive.frequency * t));
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

  void operator()(const core::PluginForce&) const {}  // refused: unmapped()

  void operator()(const core::Water& water) const {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      if (scene.bodies[i].locked) continue;
      water.mode == "step" ? lift(water, i) : float_up(water, i);
    }
  }

  // Below the cell's height:  F = buoyancy up - drag v,  dL/dt = -L  (1/s).
  //   height_ij = level + wave/2 sin(speed t + i) + wave/2 sin(i j/2),  i = trunc((x + 5 m)/0.25 m) in 0 … 40
  void lift(const core::Water& water, std::size_t body) const {
    const core::BodyState& s = state[body];
    const auto cell = [](double x) { return std::clamp(std::trunc((x + 5) / 0.25), 0.0, 40.0); };
    const double i = cell(s.position.x()), j = cell(s.position.z());
    const double waves = std::sin(water.speed * t + i) + std::sin(i * j / 2);
    if (!(s.position.y() < water.level + water.wave / 2 * waves)) return;
    wrenches[body].force += water.buoyancy * Vector3::UnitY() - water.drag * s.velocity;
    wrenches[body].torque -= inertia(body) * s.angular_velocity;
  }

  // F = -density V_sub g at the centroid of the submerged part,  F = -drag (V_sub/V) v at the centre of mass.
  void float_up(const core::Water& water, std::size_t body) const {
    const core::BodyState& s = state[body];
    const double height = water.level + water.wave * std::sin(s.position.x() - water.speed * t);
    const Submerged part = immersions[body]->below(height, s.position, s.orientation);
    if (!(part.volume > 0)) return;
    push(static_cast<int>(body), part.centroid - s.position,
         -water.buoyancy * part.volume * core::gravity(scene));
    wrenches[body].force -= water.drag * part.volume / immersions[body]->whole() * s.velocity;
  }

  // In a frame that turns with W and whose origin has the acceleration a, an element dm at r feels
  // -dm (a + 2 W x dr/dt + W' x r + W x (W x r)).  Summed over a body with spin w, for which
  // sum dm x (x.W) = (tr(I)/2 - I) W  over its arms x:
  //   F      = -m (a + 2 W x v + W' x r + W x (W x r))
  //   torque = (I W) x W + 2 (I W) x w - tr(I) W x w - I W'
  void operator()(const core::Frame& frame) const {
    const Vector3 turn = frame.angular_velocity_at(t), &faster = frame.angular_acceleration;
    const Vector3 push = std::cos(frame.frequency * t) * frame.acceleration;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const core::BodyState& s = state[i];
      const core::Matrix3 inertia = this->inertia(i);
      const Vector3 along = inertia * turn, &spin = s.angular_velocity;
      wrenches[i].force -=
          scene.bodies[i].mass *
          (push + 2 * turn.cross(s.velocity) + faster.cross(s.position) + turn.cross(turn.cross(s.position)));
      wrenches[i].torque +=
          along.cross(turn) + 2 * along.cross(spin) - inertia.trace() * turn.cross(spin) - inertia * faster;
    }
  }
};

bool floats(const core::Force& force) {
  const auto* water = std::get_if<core::Water>(&force);
  return water && water->mode != "step";
}

}  // namespace

std::optional<std::string> unmapped(const core::Scene& scene) {
  if (core::has_plugin_force(scene)) return "A plug-in's force acts, and the adapter loads no plug-ins.";
  if (std::ranges::none_of(scene.forces, floats)) return std::nullopt;
  for (const core::Body& body : scene.bodies)
    if (auto what = body.locked ? std::nullopt : Immersion::unmapped(body.shape))
      return fmt::format("Body '{}' in water: {}.", body.name, *what);
  return std::nullopt;
}

Forces::Forces(core::Scene scene, const std::vector<std::size_t>& joints)
    : scene_(std::move(scene)),
      rate_(scene_.bodies.size(), 0.0),
      immersions_(scene_.bodies.size()),
      joints_(scene_) {
  for (std::size_t k = joints.size(); k-- > 0;)
    scene_.forces.erase(scene_.forces.begin() + static_cast<std::ptrdiff_t>(joints[k]));
  const bool water = std::ranges::any_of(scene_.forces, floats);
  for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
    start_.push_back(scene_.bodies[i].mass);
    if (water && !scene_.bodies[i].locked) immersions_[i].emplace(scene_.bodies[i].shape);
  }
  for (const core::Force& force : scene_.forces) {
    any_ |= !std::holds_alternative<core::UniformGravity>(force);
    const auto* thrust = std::get_if<core::Thrust>(&force);
    if (thrust && !scene_.bodies[index(thrust->body)].locked) rate_[index(thrust->body)] += thrust->mass_rate;
  }
  for (std::size_t i = 0; i < rate_.size(); ++i)
    if (rate_[i] != 0) changing_.push_back(i);
  any_ |= core::has_fictitious_forces(scene_) || joints_.any();
}

const std::vector<Wrench>& Forces::at(double t, const core::State& state) {
  for (const std::size_t i : changing_) {
    core::Body& body = scene_.bodies[i];
    body.mass = start_[i] + t * rate_[i];
    if (!(body.mass > 0))
      throw std::runtime_error(fmt::format("the mass of '{}' is {} kg at t = {} s", body.name, body.mass, t));
  }
  wrenches_.assign(scene_.bodies.size(), {});
  const Law law{scene_, state, immersions_, t, wrenches_};
  for (const core::Force& force : scene_.forces) std::visit(law, force);
  if (core::has_fictitious_forces(scene_)) law(*scene_.frame);
  joints_.add(t, state, wrenches_);
  return wrenches_;
}

}  // namespace cylon::applied
