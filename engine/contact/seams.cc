#include "engine/contact/seams.h"

#include "engine/geometry/broad_phase.h"
#include "engine/geometry/core.h"
#include "engine/geometry/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

namespace {

// Shapes nearer than this part of their size meet, and a point that near to a shape is on it: what a scene
// that is written in decimals leaves between neighbours, and far less than a step that anybody means.
constexpr Real near_part = sizeof(Real) == 8 ? Real(1e-9) : Real(1e-5);
// How far from x the other point is, in parts of the size.
constexpr Real aside_part = sizeof(Real) == 8 ? Real(1e-6) : Real(1e-3);

Vector3 nearest(const Shape& shape, const Pose& pose, const Vector3& x) {
  Pose point = pose;
  point.position = x;
  const Separation s = separation(Shape(Sphere{0}), point, shape, pose);
  return s.gap > 0 ? s.other_point : x;
}

Real distance(const Shape& shape, const Pose& pose, const Vector3& x) {
  Pose point = pose;
  point.position = x;
  return separation(Shape(Sphere{0}), point, shape, pose).gap;
}

// max n.(y - x) over the shape.
Real beyond(const Shape& shape, const Pose& pose, const Vector3& n, const Vector3& x) {
  const Core core(shape);
  const Vector3 far = core.vertices[core.support(pose.rotation.transpose() * n)];
  return n.dot(pose.position + pose.rotation * far - x) + core.radius;
}

}  // namespace

Seams::Seams(const Model& model)
    : shapes_(model.shapes), motions_(model.motions), beside_(model.bodies.size()) {
  const auto is_obstacle = [&](std::size_t i) {
    return model.bodies[i].locked && i < model.surfaces.size() && model.surfaces[i] != no_surface &&
           !std::holds_alternative<std::monostate>(shapes_[i]);
  };
  for (std::size_t i = 0; i < shapes_.size(); ++i)
    if (is_obstacle(i)) size_ = std::max(size_, bounding_radius(shapes_[i]));
  const Vector3 near = Vector3::Constant(near_part * size_);
  std::vector<Bounds> boxes;
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    boxes.push_back(bounds(is_obstacle(i) ? shapes_[i] : Shape(), pose(motions_[i])));
    boxes.back() = {boxes.back().low - near, boxes.back().high + near};
  }
  BroadPhase broad_phase;
  for (const auto& [one, other] : broad_phase.pairs(boxes)) {
    const auto a = static_cast<std::size_t>(one), b = static_cast<std::size_t>(other);
    if (separation(shapes_[a], pose(motions_[a]), shapes_[b], pose(motions_[b])).gap > near_part * size_)
      continue;
    beside_[a].push_back(other);
    beside_[b].push_back(one);
  }
}

bool Seams::covers(int other, const Vector3& x, const Vector3& n, const Vector3& centre) const {
  const auto i = static_cast<std::size_t>(other);
  if (beside_[i].empty()) return false;
  const Real near = near_part * size_;
  Vector3 aside = centre - x;
  aside -= n.dot(aside) * n;
  const Real length = aside.norm();
  const Vector3 x_2 =
      length > near ? nearest(shapes_[i], pose(motions_[i]), x + (aside_part * size_ / length) * aside) : x;
  return std::any_of(beside_[i].begin(), beside_[i].end(), [&](int beside) {
    const auto t = static_cast<std::size_t>(beside);
    const Pose at = pose(motions_[t]);
    return distance(shapes_[t], at, x) <= near && distance(shapes_[t], at, x_2) <= near &&
           beyond(shapes_[t], at, n, x) > aside_part * size_;
  });
}

}  // namespace cylon::engine
