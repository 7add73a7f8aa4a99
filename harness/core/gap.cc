// Signed distances between the surfaces of a pair, and their rates.
#include "harness/core/convex.h"
#include "harness/core/near_pairs.h"
#include "harness/core/observable.h"
#include "harness/core/solid.h"

#include <stdexcept>

namespace cylon::core {
namespace {

const Body& body_of(const Scene& scene, int index) { return scene.bodies[static_cast<std::size_t>(index)]; }

double plane_gap(const Plane& plane, const Body& body, const BodyState& state) {
  const double height = plane.normal.dot(state.position) - plane.offset;
  if (const auto* sphere = std::get_if<Sphere>(&body.shape)) return height - sphere->radius;
  return height - support(body.shape, state.orientation.conjugate() * -plane.normal);
}

// Where the two bodies' parts are nearest, or deepest in each other.
Nearest nearest_parts(const Scene& scene, const Pair& pair, const State& state) {
  if (const auto why = gap_undefined(scene, pair)) throw std::invalid_argument(*why);
  const auto placed = [&](int body, const Part& part) {
    const BodyState& s = state[static_cast<std::size_t>(body)];
    return Placed{&part.shape, s.position + s.orientation * part.position, s.orientation * part.orientation};
  };
  const std::vector<Part> ours = convex_parts(body_of(scene, pair.body).shape),
                          theirs = convex_parts(body_of(scene, pair.other).shape);
  std::optional<Nearest> best;
  for (const Part& one : ours)
    for (const Part& other : theirs) {
      const Nearest found = nearest(placed(pair.body, one), placed(pair.other, other));
      if (!best || !(found.gap >= best->gap)) best = found;
    }
  return *best;
}

Vector3 velocity_at(const BodyState& s, const Vector3& point) {
  return s.velocity + s.angular_velocity.cross(point - s.position);
}

}  // namespace

std::optional<std::string> gap_undefined(const Scene& scene, const Pair& pair) {
  if (pair.plane >= 0) return std::nullopt;
  for (const int index : {pair.body, pair.other})
    if (convex_parts(body_of(scene, index).shape).empty())
      return "body '" + body_of(scene, index).name + "' has no shape, and so no gap to another body";
  return std::nullopt;
}

double gap(const Scene& scene, const Pair& pair, const State& state) {
  const auto a = static_cast<std::size_t>(pair.body);
  if (pair.plane >= 0)
    return plane_gap(scene.planes[static_cast<std::size_t>(pair.plane)], scene.bodies[a], state[a]);
  const auto b = static_cast<std::size_t>(pair.other);
  const auto ra = ball_radius(scene.bodies[a].shape), rb = ball_radius(scene.bodies[b].shape);
  if (ra && rb) return (state[b].position - state[a].position).norm() - *ra - *rb;
  return nearest_parts(scene, pair, state).gap;
}

double gap_rate(const Scene& scene, const Pair& pair, const State& state) {
  const auto a = static_cast<std::size_t>(pair.body);
  const Shape& shape = scene.bodies[a].shape;
  if (pair.plane >= 0) {
    const Vector3& normal = scene.planes[static_cast<std::size_t>(pair.plane)].normal;
    if (ball_radius(shape)) return normal.dot(state[a].velocity);
    const Quaternion& turn = state[a].orientation;
    const Vector3 arm = turn * farthest_point(shape, turn.conjugate() * -normal);
    return normal.dot(state[a].velocity + state[a].angular_velocity.cross(arm));
  }
  const auto b = static_cast<std::size_t>(pair.other);
  if (ball_radius(shape) && ball_radius(scene.bodies[b].shape))
    return (state[b].position - state[a].position).normalized().dot(state[b].velocity - state[a].velocity);
  const Nearest at = nearest_parts(scene, pair, state);
  return at.normal.dot(velocity_at(state[b], at.on_second) - velocity_at(state[a], at.on_first));
}

}  // namespace cylon::core
