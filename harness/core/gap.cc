// Signed distances between surfaces, from support functions (the extent of a shape in a direction).
#include "harness/core/near_pairs.h"
#include "harness/core/observable.h"
#include "harness/core/solid.h"

#include <stdexcept>

namespace cylon::core {
namespace {

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
