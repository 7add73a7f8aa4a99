#include "engine/geometry/pose.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {
namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();

struct Radius {
  Real operator()(std::monostate) const { return 0; }
  Real operator()(const Sphere& sphere) const { return sphere.radius; }
  Real operator()(const Box& box) const { return box.half_extents.norm(); }
  Real operator()(const Capsule& capsule) const { return capsule.half_length + capsule.radius; }
  Real operator()(const Hull& hull) const {
    Real most = 0;
    for (const Vector3& vertex : hull.vertices) most = std::max(most, vertex.squaredNorm());
    return std::sqrt(most);
  }
};

struct Extent {
  const Pose& pose;

  Bounds about(const Vector3& reach) const { return {pose.position - reach, pose.position + reach}; }
  Bounds operator()(std::monostate) const {
    return {Vector3::Constant(infinity), Vector3::Constant(-infinity)};
  }
  Bounds operator()(const Sphere& sphere) const { return about(Vector3::Constant(sphere.radius)); }
  Bounds operator()(const Box& box) const { return about(pose.rotation.cwiseAbs() * box.half_extents); }
  Bounds operator()(const Capsule& capsule) const {
    return about(pose.rotation.col(1).cwiseAbs() * capsule.half_length + Vector3::Constant(capsule.radius));
  }
  Bounds operator()(const Hull& hull) const {
    Bounds box = (*this)(std::monostate{});
    for (const Vector3& vertex : hull.vertices) {
      const Vector3 x = pose.rotation * vertex;
      box.low = box.low.cwiseMin(x);
      box.high = box.high.cwiseMax(x);
    }
    return {box.low + pose.position, box.high + pose.position};
  }
};

}  // namespace

Real bounding_radius(const Shape& shape) { return std::visit(Radius{}, shape); }

Bounds bounds(const Shape& shape, const Pose& pose) { return std::visit(Extent{pose}, shape); }

}  // namespace cylon::engine
