#include "harness/study/divergence.h"

#include "harness/study/relations.h"

#include <cmath>
#include <utility>

namespace cylon::study {
namespace {

using core::Quantity;

constexpr Quantity quantities[] = {
    Quantity::position,        Quantity::orientation,      Quantity::velocity, Quantity::angular_velocity,
    Quantity::linear_momentum, Quantity::angular_momentum, Quantity::energy,
};

bool of_bodies(Quantity quantity) {
  return quantity == Quantity::position || quantity == Quantity::orientation ||
         quantity == Quantity::velocity || quantity == Quantity::angular_velocity;
}

double size_of(Quantity quantity, const Scales& scales, double mass) {
  switch (quantity) {
    case Quantity::position:
      return scales.length;
    case Quantity::velocity:
      return scales.speed;
    case Quantity::angular_velocity:
      return scales.angular_velocity;
    case Quantity::linear_momentum:
      return mass * scales.speed;
    case Quantity::angular_momentum:
      return mass * scales.speed * scales.length;
    case Quantity::energy:
      return mass * scales.speed * scales.speed / 2;
    default:
      return 1;  // orientation [rad]
  }
}

// NaN is farther than any number.
bool farther(double a, double b) { return std::isnan(a) ? !std::isnan(b) : a > b; }

struct Apart {
  double distance = 0;
  int body = -1;
};

Apart apart(const core::Observable& q, const core::Scene& scene, const core::State& a, const core::State& b) {
  core::Values ours, theirs;
  core::evaluate(q, scene, a, ours);
  core::evaluate(q, scene, b, theirs);
  if (!of_bodies(q.quantity)) return {core::distance(q, ours, theirs), -1};
  Apart worst{0, 0};
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const double d = core::distance(q, {ours[i]}, {theirs[i]});
    if (farther(d, worst.distance)) worst = {d, static_cast<int>(i)};
  }
  return worst;
}

}  // namespace

std::vector<Curve> divergence(const core::Scene& scene, double duration, const core::Motion& a,
                              const core::Motion& b, double tolerance) {
  const Scales unit = scales(scene, duration);
  double mass = 0;
  for (const core::Body& body : scene.bodies)
    if (!body.locked) mass += body.mass;
  std::vector<Curve> curves;
  for (const Quantity quantity : quantities) {
    core::Observable q;
    q.quantity = quantity;
    Curve curve;
    curve.quantity = quantity, curve.unit = core::unit(q);
    curve.allowed = tolerance * size_of(quantity, unit, mass);
    for (std::size_t i = 0; i < a.states.size(); ++i) {
      const Apart here = apart(q, scene, a.states[i], b.states[i]);
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
