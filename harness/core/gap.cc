// Signed distances between surfaces, from support functions (the extent of a shape in a direction).
#include "harness/core/near_pairs.h"
#include "harness/core/observable.h"
#include "harness/core/overloaded.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cylon::core {
namespace {

// h(d) = max over the shape of d . x, with d a unit vector in the body frame [m].
double support(const Primitive& shape, const Vector3& d) {
  const double radial = std::hypot(d.x(), d.z());  // against the axis of revolution, body y
  const auto farthest = [&](const std::vector<Vector3>& points) {
    double reach = -std::numeric_limits<double>::infinity();
    for (const Vector3& p : points) reach = std::max(reach, d.dot(p));
    return reach;
  };
  return std::visit(
      Overloaded{
          [](const std::monostate&) { return 0.0; },
          [](const Sphere& s) { return s.radius; },
          [&](const Box& s) { return s.half_extents.dot(d.cwiseAbs()); },
          [&](const Capsule& s) { return s.radius + 0.5 * s.length * std::abs(d.y()); },
          [&](const Cylinder& s) { return s.radius * radial + 0.5 * s.length * std::abs(d.y()); },
          [&](const Cone& s) {
            return std::max(0.75 * s.length * d.y(), s.radius * radial - 0.25 * s.length * d.y());
          },
          [&](const Rod& s) { return 0.5 * s.length * std::abs(d.y()); },
          [&](const Disc& s) { return s.radius * radial; },
          [&](const Hull& s) { return farthest(s.vertices); },
          [&](const Mesh& s) { return farthest(s.vertices); },
      },
      shape);
}

double support(const Shape& shape, const Vector3& d) {
  return std::visit(
      Overloaded{[&](const Compound& s) {
                   double reach = -std::numeric_limits<double>::infinity();
                   for (const Part& part : s.parts)
                     reach = std::max(
                         reach, d.dot(part.position) + support(part.shape, part.orientation.conjugate() * d));
                   return reach;
                 },
                 [&](const auto& s) { return support(Primitive(s), d); }},
      shape);
}

double plane_gap(const Plane& plane, const Body& body, const BodyState& state) {
  const double height = plane.normal.dot(state.position) - plane.offset;
  if (const auto* sphere = std::get_if<Sphere>(&body.shape)) return height - sphere->radius;
  return height - support(body.shape, state.orientation.conjugate() * -plane.normal);
}

}  // namespace

std::optional<std::string> gap_undefined(const Scene& scene, const Pair& pair) {
  if (pair.plane >= 0) return std::nullopt;
  for (const int index : {pair.body, pair.other}) {
    const Body& body = scene.bodies[static_cast<std::size_t>(index)];
    if (!ball_radius(body.shape))
      return "the gap between '" + body.name + "' and another body is computed for spheres only";
  }
  return std::nullopt;
}

double gap(const Scene& scene, const Pair& pair, const State& state) {
  const auto a = static_cast<std::size_t>(pair.body);
  if (pair.plane >= 0)
    return plane_gap(scene.planes[static_cast<std::size_t>(pair.plane)], scene.bodies[a], state[a]);
  const auto b = static_cast<std::size_t>(pair.other);
  const auto ra = ball_radius(scene.bodies[a].shape), rb = ball_radius(scene.bodies[b].shape);
  if (!ra || !rb) throw std::invalid_argument(*gap_undefined(scene, pair));
  return (state[b].position - state[a].position).norm() - *ra - *rb;
}

}  // namespace cylon::core
