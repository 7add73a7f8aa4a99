#include "harness/study/divergence.h"

#include "harness/study/relations.h"

#include <cmath>
#include <utility>

namespace cylon::study {
namespace {

using core::Quantity;

// What two runs are compared in, whether each body has a value of its own, and the size of that in a scene.
struct Row {
  Quantity quantity;
  bool of_bodies;
  double (*size)(const Scales&, double mass);
};
constexpr Row rows[] = {
    {Quantity::position, true, [](const Scales& s, double) { return s.length; }},
    {Quantity::orientation, true, [](const Scales&, double) { return 1.0; }},  // [rad]
    {Quantity::velocity, true, [](const Scales& s, double) { return s.speed; }},
    {Quantity::angular_velocity, true, [](const Scales& s, double) { return s.angular_velocity; }},
    {Quantity::linear_momentum, false, [](const Scales& s, double mass) { return mass * s.speed; }},
    {Quantity::angular_momentum, false,
     [](const Scales& s, double mass) { return mass * s.speed * s.length; }},
    {Quantity::energy, false, [](const Scales& s, double mass) { return mass * s.speed * s.speed / 2; }},
};

// NaN is farther than any number.
bool farther(double a, double b) { return std::isnan(a) ? !std::isnan(b) : a > b; }

struct Apart {
  double distance = 0;
  int body = -1;
};

Apart apart(const core::Observable& q, bool of_bodies, const core::Scene& scene, const core::State& a,
            const core::State& b) {
  core::Values ours, theirs;
  core::evaluate(q, scene, a, ours);
  core::evaluate(q, scene, b, theirs);
  if (!of_bodies) return {core::distance(q, ours, theirs), -1};
  Apart worst{0, 0};
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const double d = core::distance(q, {ours[i]}, {theirs[i]});
    if (farther(d, worst.distance)) worst = {d, static_cast<int>(i)};
  }
  return worst;
}

}  // namespace

std::vector<Curve> divergence(const core::Scene& scene, double duration, const core::Trajectory& a,
                              const core::Trajectory& b, double tolerance) {
  const Scales unit = scales(scene, duration);
  double mass = 0;
  for (const core::Body& body : scene.bodies)
    if (!body.locked) mass += body.mass;
  std::vector<Curve> curves;
  for (const Row& row : rows) {
    core::Observable q;
    q.quantity = row.quantity;
    Curve curve;
    curve.quantity = row.quantity, curve.unit = core::unit(q);
    curve.allowed = tolerance * row.size(unit, mass);
    for (std::size_t i = 0; i < a.states.size(); ++i) {
      const Apart here = apart(q, row.of_bodies, scene, a.states[i], b.states[i]);
      if (!curve.first && !(here.distance <= curve.allowed)) curve.first = i;
      if (i > 0 && farther(here.distance, curve.distance[curve.largest])) curve.largest = i;
      curve.distance.push_back(here.distance);
      curve.body.push_back(here.body);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

const Curve* first_to_part(std::span<const Curve> curves) {
  const Curve* result = nullptr;
  const auto excess = [](const Curve& c) {
    return c.distance[*c.first] / c.allowed;
  };  // inf, NaN: at tolerance 0
  for (const Curve& curve : curves)
    if (curve.first && (!result || *curve.first < *result->first ||
                        (*curve.first == *result->first && farther(excess(curve), excess(*result)))))
      result = &curve;
  return result;
}

// The convergents p/q of b/a, by Euclid's algorithm.
std::optional<Multiples> common_multiple(double a, double b) {
  constexpr std::int64_t most = 10'000;
  double rest = b / a;
  std::int64_t p = 1, p_before = 0, q = 0, q_before = 1;
  while (rest < static_cast<double>(most)) {
    const auto whole = static_cast<std::int64_t>(std::floor(rest));
    p_before += whole * p, q_before += whole * q;
    std::swap(p, p_before), std::swap(q, q_before);
    if (p > most || q > most) break;
    if (p > 0 && std::abs(static_cast<double>(p) * a - static_cast<double>(q) * b) <=
                     1e-9 * static_cast<double>(p) * a)
      return Multiples{p, q};
    rest = 1 / (rest - static_cast<double>(whole));
  }
  return std::nullopt;
}

}  // namespace cylon::study
