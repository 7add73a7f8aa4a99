#include "harness/core/force_law.h"

#include "harness/core/anchor.h"
#include "harness/core/joint_coordinates.h"

#include <algorithm>
#include <cmath>
#include <concepts>

namespace cylon::core {
namespace {

// ---- Laws and symmetries ---------------------------------------------------------------------------

constexpr const char* holds = nullptr;

Broken broken(const UniformGravity& g) {
  return {.energy = holds,
          .momentum = g.acceleration.isZero(0) ? holds : "gravity acts from outside",
          .reversal = holds,
          .any_instant = holds,
          .boost = holds,
          .free_fall = holds,
          .restatement = holds,
          .superposition = holds};
}

Broken broken(const Spring& s) {
  const char* damped = s.damping == 0 ? holds : "a spring is damped";
  const char* pinned = s.to == world ? "a spring ends at the world" : holds;
  const bool linear =
      s.rest_length == 0 && s.damping == 0 && s.anchor.isZero() && (s.to == world || s.to_anchor.isZero());
  return {.energy = damped,
          .momentum = pinned,
          .reversal = damped,
          .any_instant = holds,
          .boost = pinned,
          .free_fall = pinned,
          .restatement = holds,
          .superposition = linear ? holds : "a spring has a length, a damper or an arm"};
}

Broken broken(const JointCoordinate& c) {
  const bool loses = c.damping != 0 || c.quadratic_damping != 0 || c.friction != 0;
  const bool plastic = has_limit(c) && c.restitution < 1;
  const char* energy = loses             ? "a joint is damped or has friction"
                       : plastic         ? "the limits of a joint lose energy"
                       : target_moves(c) ? "a target of a joint moves"
                                         : holds;
  return {.energy = energy,
          .momentum = holds,
          .reversal = energy,
          .any_instant = target_moves(c) ? "a target of a joint moves" : holds,
          .boost = holds,
          .free_fall = holds,
          .restatement = holds,
          .superposition = "something acts along a joint"};
}

Broken broken(const Drag&) {
  return {.energy = "drag loses energy",
          .momentum = "drag is against a medium at rest",
          .reversal = "drag loses energy",
          .any_instant = holds,
          .boost = "drag is against a medium at rest",
          .free_fall = "drag is against a medium at rest",
          .restatement = holds,
          .superposition = holds};
}

Broken broken(const Thrust& t) {
  const char* changes = t.mass_rate != 0 ? "a mass changes" : holds;
  return {.energy = "a thrust does work",
          .momentum = "a thrust acts from outside",
          .reversal = changes,
          .any_instant = changes,
          .boost = holds,
          .free_fall = t.exchanged_velocity ? "mass is exchanged with something that does not fall" : holds,
          .restatement = holds,
          .superposition = holds};
}

Broken broken(const Drive&) {
  return {.energy = "a drive does work",
          .momentum = "a drive acts from outside",
          .reversal = "a drive has a phase",
          .any_instant = "a drive has a phase",
          .boost = holds,
          .free_fall = holds,
          .restatement = holds,
          .superposition = holds};
}

Broken broken(const Attraction&) {
  return {.energy = holds,
          .momentum = holds,
          .reversal = holds,
          .any_instant = holds,
          .boost = holds,
          .free_fall = holds,
          .restatement = holds,
          .superposition = "attraction is not linear"};
}

Broken broken(const Water&) {
  constexpr const char* place = "water has a place and axes of its own";
  constexpr const char* waves = "waves have a phase";
  return {.energy = "water takes up energy",
          .momentum = "water acts from outside",
          .reversal = waves,
          .any_instant = waves,
          .boost = place,
          .free_fall = place,
          .restatement = place,
          .superposition = waves};
}

Broken broken(const PluginForce&) {
  constexpr const char* unknown = "a plug-in's force acts, of which this is not known";
  return {.energy = unknown,
          .momentum = unknown,
          .reversal = unknown,
          .any_instant = unknown,
          .boost = unknown,
          .free_fall = unknown,
          .restatement = unknown,
          .superposition = unknown};
}

// ---- Potential energies ----------------------------------------------------------------------------

// Their work is not part of a conserved energy.  A force that is neither listed here nor has its own two
// functions below does not compile.
template <class F>
concept WithoutPotential = std::same_as<F, Drag> || std::same_as<F, Thrust> || std::same_as<F, Drive> ||
    std::same_as<F, Water> || std::same_as<F, PluginForce>;

template <WithoutPotential F>
double energy(const F&, const Scene&, const State&, double (*)(double)) {
  return 0;
}
template <WithoutPotential F>
double error(const F&, const Scene&, const State&, const StateError&) {
  return 0;
}

// U = -m g.x of each body that can move and has no gravity of its own.
double energy(const UniformGravity& gravity, const Scene& scene, const State& state, double (*size)(double)) {
  double total = 0;
  for (std::size_t i = 0; i < state.size(); ++i)
    if (!scene.bodies[i].locked && !scene.bodies[i].gravity)
      total += size(-scene.bodies[i].mass * gravity.acceleration.dot(state[i].position));
  return total;
}

// |dU| <= m |g| |dx|
double error(const UniformGravity& gravity, const Scene& scene, const State& state, const StateError& e) {
  double total = 0;
  for (std::size_t i = 0; i < state.size(); ++i)
    if (!scene.bodies[i].gravity) total += scene.bodies[i].mass * gravity.acceleration.norm() * e.position;
  return total;
}

// The same of bodies with their own.
double own_gravity_error(const Scene& scene, const State& state, const StateError& e) {
  double total = 0;
  for (std::size_t i = 0; i < state.size(); ++i)
    if (const Body& body = scene.bodies[i]; body.gravity)
      total += body.mass * body.gravity->norm() * e.position;
  return total;
}

// |d| - L, d from anchor to anchor.
double stretch(const Spring& spring, const State& state) {
  const Vector3 d = anchor(state, spring.to, spring.to_anchor) - anchor(state, spring.body, spring.anchor);
  return d.norm() - spring.rest_length;
}

// U = k (|d| - L)^2 / 2
double energy(const Spring& spring, const Scene&, const State& state, double (*size)(double)) {
  const double x = stretch(spring, state);
  return size(0.5 * spring.stiffness * x * x);
}

// |dU| <= k ||d| - L| (|dx_a| + |a| |dtheta_a| + |dx_b| + |b| |dtheta_b|); an end in the world does not move.
double error(const Spring& spring, const Scene&, const State& state, const StateError& e) {
  const auto end = [&](int body, const Vector3& lever) {
    return body == world ? 0 : e.position + lever.norm() * e.orientation;
  };
  return spring.stiffness * std::abs(stretch(spring, state)) *
         (end(spring.body, spring.anchor) + end(spring.to, spring.to_anchor));
}

// Distance of the two centres.
double apart(const Attraction& pull, const State& state) {
  return (state[static_cast<std::size_t>(pull.to)].position -
          state[static_cast<std::size_t>(pull.body)].position)
      .norm();
}

// U = -G m_a m_b / d
double energy(const Attraction& pull, const Scene& scene, const State& state, double (*size)(double)) {
  const auto a = static_cast<std::size_t>(pull.body), b = static_cast<std::size_t>(pull.to);
  return size(-pull.strength * scene.bodies[a].mass * scene.bodies[b].mass / apart(pull, state));
}

// |dU| <= G m_a m_b / d^2 (|dx_a| + |dx_b|)
double error(const Attraction& pull, const Scene& scene, const State& state, const StateError& e) {
  const auto a = static_cast<std::size_t>(pull.body), b = static_cast<std::size_t>(pull.to);
  const double d = apart(pull, state);
  return std::abs(pull.strength) * scene.bodies[a].mass * scene.bodies[b].mass / (d * d) *
         (e.position + e.position);
}

// ---- Scales ----------------------------------------------------------------------------------------

double mass(const Scene& scene, int body) { return scene.bodies[static_cast<std::size_t>(body)].mass; }

template <WithoutPotential F>
double squared(const F&, const Scene&, double) {
  return 0;
}

// v^2 = 2 g L; several gravities add up, so theirs is with the scene's.
double squared(const UniformGravity&, const Scene&, double) { return 0; }

// v^2 = (k/m) L^2
double squared(const Spring& k, const Scene& scene, double length) {
  return k.stiffness / mass(scene, k.body) * length * length;
}

// v^2 = G m / L
double squared(const Attraction& a, const Scene& scene, double length) {
  return a.strength * std::max(mass(scene, a.body), mass(scene, a.to)) / length;
}

}  // namespace

std::vector<Broken> broken_by(const Scene& scene) {
  std::vector<Broken> all;
  for (const Force& force : scene.forces)
    all.push_back(std::visit([](const auto& f) { return broken(f); }, force));
  for (const Body& body : scene.bodies)
    if (body.gravity && !body.locked) {
      all.push_back(broken(UniformGravity{*body.gravity}));
      if (all.back().momentum) break;
    }
  for (const Joint& joint : scene.joints)
    for_each_coordinate(joint, [&](const JointCoordinate& c) { all.push_back(broken(c)); });
  return all;
}

double squared_speed(const Force& force, const Scene& scene, double length) {
  return std::visit([&](const auto& f) { return squared(f, scene, length); }, force);
}

double potential(const Force& force, const Scene& scene, const State& state, double (*size)(double)) {
  return std::visit([&](const auto& f) { return energy(f, scene, state, size); }, force);
}

double own_gravity_potential(const Scene& scene, const State& state, double (*size)(double)) {
  double total = 0;
  for (std::size_t i = 0; i < state.size(); ++i)
    if (const Body& body = scene.bodies[i]; body.gravity && !body.locked)
      total += size(-body.mass * body.gravity->dot(state[i].position));
  return total;
}

double potential_total(const Scene& scene, const State& state, double (*size)(double)) {
  double total = own_gravity_potential(scene, state, size);
  for (const Force& force : scene.forces) total += potential(force, scene, state, size);
  for (const Joint& joint : scene.joints)
    if (acted_on(joint)) total += joint_potential(held_joint(scene, joint), state, size);
  return total;
}

double potential_error_total(const Scene& scene, const State& state, const StateError& e) {
  double total = own_gravity_error(scene, state, e);
  for (const Force& force : scene.forces)
    total += std::visit([&](const auto& f) { return error(f, scene, state, e); }, force);
  for (const Joint& joint : scene.joints)
    if (acted_on(joint)) total += joint_potential_error(held_joint(scene, joint), state, e);
  return total;
}

}  // namespace cylon::core
