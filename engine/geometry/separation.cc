#include "engine/geometry/separation.h"

#include "engine/geometry/closed_forms.h"
#include "engine/geometry/touch.h"

#include <array>
#include <limits>

namespace cylon::engine {
namespace {

using Row = Separation (*)(const Shape&, const Pose&, const Shape&, const Pose&);

Separation nothing(const Shape&, const Pose& pose, const Shape&, const Pose& other) {
  return {std::numeric_limits<Real>::infinity(), Vector3::UnitY(), pose.position, other.position};
}

Separation general(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose) {
  const Couple couple(body, pose, other, other_pose);
  const Touch t = touch(couple);
  const Vector3 a = t.a - couple.a.radius * t.normal, b = t.b + couple.b.radius * t.normal;
  return {t.gap - couple.a.radius - couple.b.radius, pose.rotation * t.normal,
          pose.position + pose.rotation * a, pose.position + pose.rotation * b};
}

template <Row row>
Separation swapped(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose) {
  const Separation s = row(other, other_pose, body, pose);
  return {s.gap, -s.normal, s.other_point, s.point};
}

constexpr Row ball_ball = sphere_sphere, ball_box = sphere_box, ball_rod = sphere_capsule,
              rod_rod = capsule_capsule;

// Rows and columns in the order of Shape: none, sphere, box, capsule, hull.
constexpr std::array<std::array<Row, 5>, 5> table = {{
    {nothing, nothing, nothing, nothing, nothing},
    {nothing, ball_ball, ball_box, ball_rod, general},
    {nothing, swapped<ball_box>, general, general, general},
    {nothing, swapped<ball_rod>, swapped<general>, rod_rod, general},
    {nothing, swapped<general>, swapped<general>, swapped<general>, general},
}};
static_assert(std::variant_size_v<Shape> == table.size());

}  // namespace

Separation separation(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose) {
  return table[body.index()][other.index()](body, pose, other, other_pose);
}

// gap = min_x n.x - offset - r, over the core's vertices.
Separation separation(const Shape& body, const Pose& pose, const Plane& plane) {
  if (body.index() == 0) return nothing(body, pose, body, pose);
  const Core core(body);
  const Vector3 n = pose.rotation.transpose() * plane.normal;
  const Vector3 lowest = pose.rotation * core.vertices[core.support(-n)];
  const Real gap = plane.normal.dot(pose.position) - plane.offset + plane.normal.dot(lowest) - core.radius;
  const Vector3 point = pose.position + lowest - core.radius * plane.normal;
  return {gap, plane.normal, point, point - gap * plane.normal};
}

}  // namespace cylon::engine
