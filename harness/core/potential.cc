#include "harness/core/potential.h"

#include "harness/core/anchor.h"

#include <cmath>
#include <concepts>

namespace cylon::core {
namespace {

// Their work is not part of a conserved energy.  A force that is neither listed here nor has its own two
// functions below does not compile.
template <class F>
concept WithoutPotential =
    std::same_as<F, Drag> || std::same_as<F, Thrust> || std::same_as<F, Drive> || std::same_as<F, Water>;

template <WithoutPotential F>
double energy(const F&, const Scene&, const State&, double (*)(double)) {
  return 0;
}
template <WithoutPotential F>
double error(const F&, const Scene&, const State&, const StateError&) {
  return 0;
}

// U = -m g.x of each body that can move.
double energy(const UniformGravity& gravity, const Scene& scene, const State& state, double (*size)(double)) {
  double total = 0;
  for (std::size_t i = 0; i < state.size(); ++i)
    if (!scene.bodies[i].locked)
      total += size(-scene.bodies[i].mass * gravity.acceleration.dot(state[i].position));
  return total;
}

// |dU| <= m |g| |dx|
double error(const UniformGravity& gravity, const Scene& scene, const State& state, const StateError& e) {
  double total = 0;
  for (std::size_t i = 0; i < state.size(); ++i)
    total += scene.bodies[i].mass * gravity.acceleration.norm() * e.position;
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

}  // namespace

double potential(const Force& force, const Scene& scene, const State& state, double (*size)(double)) {
  return std::visit([&](const auto& f) { return energy(f, scene, state, size); }, force);
}

double potential_error(const Force& force, const Scene& scene, const State& state, const StateError& e) {
  return std::visit([&](const auto& f) { return error(f, scene, state, e); }, force);
}

}  // namespace cylon::core
