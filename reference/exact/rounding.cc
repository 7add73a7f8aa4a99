#include "reference/exact/rounding.h"

#include "reference/exact/nudges.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::exact {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double step = 1e-12;
constexpr int times = 128;

double angle(const core::Quaternion& p, const core::Quaternion& q) {
  const double chord = std::min((p.coeffs() - q.coeffs()).norm(), (p.coeffs() + q.coeffs()).norm());
  return 4 * std::asin(std::min(1.0, chord / 2));
}

// Largest difference of two states, and of their sizes if `b` is nothing, over the bodies.
void raise(core::StateError& most, const core::State& a, const core::State& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    most.position = std::max(most.position, (a[i].position - b[i].position).norm());
    most.velocity = std::max(most.velocity, (a[i].velocity - b[i].velocity).norm());
    most.orientation = std::max(most.orientation, angle(a[i].orientation, b[i].orientation));
    most.angular_velocity =
        std::max(most.angular_velocity, (a[i].angular_velocity - b[i].angular_velocity).norm());
  }
}

void add(core::StateError& sum, double factor, const core::StateError& e) {
  sum.position += factor * e.position;
  sum.velocity += factor * e.velocity;
  sum.orientation += factor * e.orientation;
  sum.angular_velocity += factor * e.angular_velocity;
}

}  // namespace

core::StateError rounding_error(const core::Scene& scene, const Solve& solve, double horizon) {
  const auto exact = solve(scene);
  std::vector<core::State> states;
  for (int k = 0; k <= times; ++k) states.push_back(exact(horizon * k / times));

  core::StateError size;
  for (const core::State& state : states) raise(size, state, core::State(state.size()));
  size.orientation = 1;
  core::StateError error;
  add(error, 8 * eps, size);

  for (const core::Scene& nudged : nudged(scene, step)) {
    const auto moved = solve(nudged);
    core::StateError most;
    for (int k = 0; k <= times; ++k) {
      raise(most, moved(horizon * k / times), states[static_cast<std::size_t>(k)]);
    }
    add(error, 4 * eps / step, most);
  }
  return error;
}

}  // namespace cylon::exact
