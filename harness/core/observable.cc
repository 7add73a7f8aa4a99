#include "harness/core/observable.h"

#include "harness/core/observable_rows.h"

#include <array>
#include <cmath>

namespace cylon::core {

std::string_view name(Quantity quantity) { return observable_row(quantity).name; }

std::span<const int> axes(Component component) {
  static constexpr std::array<int, 3> each = {0, 1, 2};
  static constexpr std::array<int, 2> level = {0, 2};
  const std::span<const int> all = each;
  switch (component) {
    case Component::all:
      return all;
    case Component::x:
      return all.subspan(0, 1);
    case Component::y:
      return all.subspan(1, 1);
    case Component::z:
      return all.subspan(2, 1);
    case Component::horizontal:
      return level;
  }
  return all;
}

Vector3 only(const Vector3& v, Component component) {
  Vector3 kept = Vector3::Zero();
  for (const int axis : axes(component)) kept[axis] = v[axis];
  return kept;
}

std::string_view unit(const Observable& q) {
  if (q.quantity == Quantity::event) return unit(q.event_quantity);
  return observable_row(q.quantity).unit;
}

std::optional<std::string> undefined_in(const Observable& q, const Scene& scene) {
  return observable_row(q.quantity).undefined_in(q, scene);
}

void evaluate(const Observable& q, const Scene& scene, const State& state, Values& values) {
  values.clear();
  observable_row(q.quantity).evaluate(q, scene, state, values);
}

double distance(const Observable& q, const Values& a, const Values& b) {
  return observable_row(q.quantity).distance(a, b);
}

double magnitude(const Observable& q, const Values& values) {
  return observable_row(q.quantity).magnitude(values);
}

std::optional<Vector3> symmetry_axis(const Body& body) {
  const PrincipalAxes principal = principal_axes(body.inertia);
  const Vector3& m = principal.moments;
  const double tolerance = 1e-9 * m.maxCoeff();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (std::abs(m[j] - m[k]) <= tolerance && std::abs(m[i] - m[j]) > tolerance)
      return principal.rotation * Vector3::Unit(i);
  }
  return std::nullopt;
}

}  // namespace cylon::core
