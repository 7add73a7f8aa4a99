#include "engine/geometry/closed_forms.h"

#include "engine/geometry/segments.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {
namespace {

Vector3 any_across(const Vector3& x) {
  int least = 0;
  x.cwiseAbs().minCoeff(&least);
  return x.cross(Vector3::Unit(least));
}

}  // namespace

// d = a - b, n = d/|d|, gap = |d| - r_a - r_b.
Separation between_points(const Vector3& a, Real radius_a, const Vector3& b, Real radius_b,
                          const Vector3& across, Real size) {
  const Vector3 d = a - b;
  const Real distance = d.norm();
  Separation result;
  if (distance > 4 * epsilon * size) {
    result.normal = d / distance;
  } else {
    result.normal = across.normalized();
    if (result.normal.dot(d) < 0) result.normal = -result.normal;
  }
  result.gap = distance - radius_a - radius_b;
  result.point = a - radius_a * result.normal;
  result.other_point = b + radius_b * result.normal;
  return result;
}

Separation closed_form(const Sphere& a, const Pose& pose, const Sphere& b, const Pose& other_pose) {
  return between_points(pose.position, a.radius, other_pose.position, b.radius, Vector3::UnitY(), 0);
}

Separation closed_form(const Sphere& sphere, const Pose& pose, const Capsule& capsule,
                       const Pose& other_pose) {
  const Vector3 along = other_pose.rotation.col(1);
  const Vector3 d = pose.position - other_pose.position;
  const Real t = std::clamp(along.dot(d), -capsule.half_length, capsule.half_length);
  return between_points(pose.position, sphere.radius, other_pose.position + t * along, capsule.radius,
                        any_across(along), capsule.half_length);
}

Separation closed_form(const Capsule& a, const Pose& pose, const Capsule& b, const Pose& other_pose) {
  const Vector3 u = pose.rotation.col(1), w = other_pose.rotation.col(1);
  const SegmentPoints x = nearest_on_segments(Vector3::Zero(), u, a.half_length,
                                              other_pose.position - pose.position, w, b.half_length);
  Vector3 across = u.cross(w);
  if (x.parallel) across = any_across(u);
  return between_points(pose.position + x.s * u, a.radius, other_pose.position + x.t * w, b.radius, across,
                        a.half_length + b.half_length);
}

// p: the centre in the box's axes, q: the point of the box nearest to it.  Outside gap = |p - q| - r along
// p - q; inside gap = -(least way out) - r along that face's normal.
Separation closed_form(const Sphere& sphere, const Pose& pose, const Box& box, const Pose& other_pose) {
  const Real radius = sphere.radius;
  const Vector3& half = box.half_extents;
  const Vector3 p = other_pose.rotation.transpose() * (pose.position - other_pose.position);
  Vector3 q = p.cwiseMax(-half).cwiseMin(half), n = p - q;
  Real distance = n.norm();
  if (distance > 0) {
    n /= distance;
  } else {
    int face = 0;
    distance = -(half - p.cwiseAbs()).minCoeff(&face);
    n = (p[face] < 0 ? Real(-1) : Real(1)) * Vector3::Unit(face);
    q -= distance * n;
  }
  Separation result;
  result.gap = distance - radius;
  result.normal = other_pose.rotation * n;
  result.other_point = other_pose.position + other_pose.rotation * q;
  result.point = pose.position - radius * result.normal;
  return result;
}

// In the half-plane (r, y) through the axis and the centre the frustum is a trapezoid with the edges (n, from, to) of the
// low disc, the side and the high disc.  Inside gap = max n.(q - from) - radius; outside the distance to the nearest
// edge, along n over it and away from its end beside it.
Separation closed_form(const Sphere& sphere, const Pose& pose, const Frustum& frustum,
                       const Pose& other_pose) {
  using Flat = Eigen::Matrix<Real, 2, 1>;
  struct Side {
    Flat n, from, to;
  };
  const Vector3 p = other_pose.rotation.transpose() * (pose.position - other_pose.position);
  const Real r = std::hypot(p.x(), p.z());
  const Vector3 out = r > 0 ? Vector3(p.x() / r, 0, p.z() / r) : Vector3(Vector3::UnitX());
  const Flat q(r, p.y()), low(frustum.low_radius, frustum.low), high(frustum.high_radius, frustum.high);
  const Side sides[] = {{Flat(high.y() - low.y(), low.x() - high.x()).normalized(), low, high},
                        {Flat(0, -1), Flat(0, low.y()), low},
                        {Flat(0, 1), Flat(0, high.y()), high}};
  Real widest = -std::numeric_limits<Real>::infinity(), gap = -widest;
  Flat n, foot;
  for (const Side& side : sides) {
    const Real above = side.n.dot(q - side.from);
    if (side.from != side.to && above > widest) widest = above, n = side.n;
  }
  if (widest <= 0) gap = widest, foot = q - gap * n;
  for (const Side& side : sides) {
    if (widest <= 0 || side.from == side.to) continue;  // inside; a tip
    const Flat along = side.to - side.from;
    const Real part = along.dot(q - side.from) / along.squaredNorm(), above = side.n.dot(q - side.from);
    const bool over = part >= 0 && part <= 1;
    const Flat end = part < 0 ? side.from : side.to, way = q - end;
    const Real distance = over ? std::abs(above) : way.norm();
    if (!(distance < gap)) continue;
    gap = distance;
    foot = over ? Flat(q - above * side.n) : end;
    if (over || distance > 0) n = over ? side.n : Flat(way / distance);
  }
  Separation result;
  const auto world = [&](const Flat& x) {
    return Vector3(other_pose.rotation * (x.x() * out + x.y() * Vector3::UnitY()));
  };
  result.gap = gap - sphere.radius;
  result.normal = world(n);
  result.other_point = other_pose.position + world(foot);
  result.point = pose.position - sphere.radius * result.normal;
  return result;
}

// The segments' common part along a, both ends of which are within the margin.
Manifold closed_manifold(const Capsule& a, const Pose& pose, const Capsule& b, const Pose& other_pose,
                         Real margin) {
  const Separation s = closed_form(a, pose, b, other_pose);
  const Vector3 u = pose.rotation.col(1), w = other_pose.rotation.col(1),
                d = other_pose.position - pose.position;
  const Real along = u.dot(w);
  const Real middle = u.dot(d), reach = std::abs(along) * b.half_length;
  const Real low = std::max(-a.half_length, middle - reach), high = std::min(a.half_length, middle + reach);
  const bool parallel = std::abs(along) > Real(0.99);
  if (!parallel || !(high > low) || !(s.gap < margin)) return one_point(s, margin);
  Manifold result;
  result.normal = s.normal;
  result.count = 0;
  for (const Real t : {low, high}) {
    const Vector3 on_a = t * u, on_b = d + w * ((t - middle) / along);
    const Real gap = s.normal.dot(on_a - on_b) - a.radius - b.radius;
    if (!(gap < margin)) continue;
    const Vector3 point = pose.position + on_a - (a.radius + gap / 2) * s.normal;
    const auto feature = static_cast<std::uint32_t>(t == low ? 1 : 2);
    result.points[static_cast<std::size_t>(result.count++)] = {point, gap, feature};
  }
  return result.count == 2 ? result : one_point(s, margin);
}

}  // namespace cylon::engine
