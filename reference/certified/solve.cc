#include "reference/certified/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::certified {
namespace {

template <std::size_t N>
std::array<Ball, N> read(const Step& step, const std::array<int, N>& nodes, double t) {
  std::array<Ball, N> values;
  for (std::size_t i = 0; i < N; ++i) values[i] = step.at(nodes[i], t);
  return values;
}

Sampled sample(const Model& model, const Step& step, double t) {
  Sampled result;
  result.time = t;
  for (const BodyNodes& body : model.bodies)
    result.bodies.push_back({read(step, body.position, t), read(step, body.velocity, t),
                             read(step, body.orientation, t), read(step, body.angular_velocity, t)});
  for (const int state : model.graph.states())
    result.conditioning = std::max(result.conditioning, step.sensitivity(state, t).lpNorm<1>());
  return result;
}

Certificate attempt(const core::Scene& scene, std::span<const double> times, const Effort& effort,
                    const Numbers& numbers) {
  Certificate result;
  result.bits = effort.bits;
  // A body alone that nothing moves has no state; a positive horizon keeps even that a solution.
  const double horizon = times.back() > 0 ? times.back() : 1e-3;
  const Model model = make_model(scene, horizon, effort.bits, numbers);
  follow(model, horizon, effort, [&](const Step& step) {
    ++result.steps;
    while (result.samples.size() < times.size()) {
      const double t = times[result.samples.size()];
      if (t > step.start + step.length) break;
      result.samples.push_back(sample(model, step, t));
    }
    return result.samples.size() < times.size();
  });
  for (const Sampled& s : result.samples)
    for (const BodyBalls& body : s.bodies) result.radius = std::max(result.radius, body.radius());
  return result;
}

}  // namespace

double BodyBalls::radius() const {
  double largest = 0;
  const auto add = [&](const auto& balls) {
    for (const Ball& x : balls) largest = x.finite() ? std::max(largest, x.radius()) : HUGE_VAL;
  };
  add(position), add(velocity), add(orientation), add(angular_velocity);
  return largest;
}

// Six digits of room for what the motion amplifies.
Attempts::Attempts(const Goal& goal) : goal_(goal), best_(std::numeric_limits<double>::infinity()) {
  constexpr int guard_bits = 64;
  aim(std::max(goal.radius * 1e-6, std::ldexp(1.0, guard_bits - static_cast<int>(goal.most_bits))));
}

void Attempts::aim(double step_error) {
  constexpr slong guard = 36, word = 64;
  effort_.step_error = step_error;
  const slong wanted = static_cast<slong>(std::ceil(-std::log2(step_error))) + guard;
  effort_.bits = std::max<slong>(128, (wanted + word - 1) / word * word);
}

bool Attempts::next(double radius) {
  if (radius <= goal_.radius) return false;
  if (std::isfinite(radius) && radius > 0.5 * best_)
    return false;  // the numbers of the scene set this radius
  best_ = std::min(best_, radius);
  aim(std::isfinite(radius) ? effort_.step_error * std::max(1e-60, goal_.radius / radius) * 1e-3
                            : effort_.step_error * effort_.step_error);
  return effort_.step_error > 1e-280 && effort_.bits <= goal_.most_bits;
}

Certificate certify(const core::Scene& scene, std::span<const double> times, const Goal& goal,
                    const Numbers& numbers) {
  Attempts attempts(goal);
  Certificate best;
  best.radius = std::numeric_limits<double>::infinity();
  std::string stuck;
  double radius = 0;
  do {
    radius = std::numeric_limits<double>::infinity();
    try {
      Certificate found = attempt(scene, times, attempts.effort(), numbers);
      radius = found.radius;
      if (radius < best.radius) best = std::move(found);
    } catch (const Stuck& error) {
      stuck = error.what();
    }
  } while (attempts.next(radius));
  if (!std::isfinite(best.radius)) throw core::OutOfDomain("certified: " + stuck);
  best.reached = best.radius <= goal.radius;
  if (!best.reached)
    best.reason =
        fmt::format("radius {:.2g} at {} bits; {:.2g} was asked for", best.radius, best.bits, goal.radius);
  return best;
}

}  // namespace cylon::certified
