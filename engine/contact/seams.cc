#include "engine/contact/seams.h"

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
  std::vector<int> locked;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (!model.bodies[i].locked || i >= model.surfaces.size() || model.surfaces[i] == no_surface) continue;
    if (std::holds_alternative<std::monostate>(shapes_[i])) continue;
    locked.push_back(static_cast<int>(i));
    size_ = std::max(size_, bounding_radius(shapes_[i]));
  }
  for (std::size_t k = 0; k < locked.size(); ++k) {
    for (std::size_t m = k + 1; m < locked.size(); ++m) {
      const auto a = static_cast<std::size_t>(locked[k]), b = static_cast<std::size_t>(locked[m]);
      const Real reach = bounding_radius(shapes_[a]) + bounding_radius(shapes_[b]) + near_part * size_;
      if ((motions_[a].position - motions_[b].position).squaredNorm() > reach * reach) continue;
      if (separation(shapes_[a], pose(motions_[a]), shapes_[b], pose(motions_[b])).gap > near_part * size_)
        continue;
      beside_[a].push_back(locked[m]);
      beside_[b].push_back(locked[k]);
    }
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
