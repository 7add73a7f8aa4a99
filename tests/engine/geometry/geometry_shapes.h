// Shapes of every kind, general poses, and the signed distance by asking every pair of features: slow, and by
// other formulas than the engine's.
#pragma once

#include "engine/geometry/hull.h"
#include "engine/geometry/separation.h"
#include "engine/rotation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace cylon::engine::geometry_test {

constexpr Real eps = std::numeric_limits<Real>::epsilon();

/// A reproducible sequence; uniform in [-1, 1].
class Sequence {
 public:
  explicit Sequence(std::uint64_t seed) : state_(seed * 2 + 1) {}
  Real next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<Real>(static_cast<std::int64_t>(state_) >> 11) /
           static_cast<Real>(std::int64_t{1} << 52);
  }
  Vector3 vector() {
    const Real x = next(), y = next(), z = next();
    return {x, y, z};
  }
  Vector3 direction() {
    for (;;) {
      const Vector3 x = vector();
      if (x.squaredNorm() < 1 && x.squaredNorm() > Real(0.01)) return x.normalized();
    }
  }
  Matrix3 rotation() { return exponential(Real(3.1) * vector()).toRotationMatrix(); }

 private:
  std::uint64_t state_;
};

inline Hull cloud_hull(int points, std::uint64_t seed, const Vector3& stretch = Vector3::Ones()) {
  Sequence random(seed);
  std::vector<Vector3> cloud;
  for (int i = 0; i < points; ++i) cloud.emplace_back(random.direction().cwiseProduct(stretch));
  return make_hull(cloud);
}

inline Hull prism(int corners, Real radius, Real half_height) {
  std::vector<Vector3> points;
  for (int i = 0; i < corners; ++i) {
    const Real angle = Real(2 * 3.14159265358979323846) * static_cast<Real>(i) / static_cast<Real>(corners);
    for (const Real y : {-half_height, half_height})
      points.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
  }
  return make_hull(points);
}

struct Named {
  std::string name;
  Shape shape;
};

inline const std::vector<Named>& shapes() {
  static const std::vector<Named> all = {
      {"point", Sphere{0}},
      {"sphere", Sphere{Real(0.37)}},
      {"box", Box{{Real(0.5), Real(0.31), Real(0.72)}}},
      {"sliver", Box{{Real(1.1), Real(0.002), Real(0.4)}}},
      {"capsule", Capsule{Real(0.21), Real(0.6)}},
      {"rod", Capsule{0, Real(0.8)}},
      {"tetrahedron", make_hull({{Real(0.6), Real(-0.2), Real(0.1)},
                                 {Real(-0.4), Real(-0.3), Real(0.5)},
                                 {Real(-0.1), Real(0.7), Real(-0.1)},
                                 {Real(0.1), Real(-0.4), Real(-0.6)}})},
      {"cloud", cloud_hull(30, 7, {Real(0.9), Real(0.5), Real(0.6)})},
      {"prism", prism(12, Real(0.5), Real(0.4))},
  };
  return all;
}

// ---- The slow way ----------------------------------------------------------------------------------

struct Solid {  // world axes
  std::vector<Vector3> vertices, normals;
  std::vector<std::array<Vector3, 2>> edges;
  std::vector<std::array<Vector3, 3>> triangles;
  Real radius = 0;
};

inline Solid solid(const Shape& shape, const Pose& pose) {
  Solid s;
  const auto place = [&](const Vector3& x) { return Vector3(pose.position + pose.rotation * x); };
  Hull hull;
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    s.vertices = {pose.position}, s.radius = sphere->radius;
  } else if (const auto* capsule = std::get_if<Capsule>(&shape)) {
    s.vertices = {place({0, -capsule->half_length, 0}), place({0, capsule->half_length, 0})};
    s.edges = {{s.vertices[0], s.vertices[1]}}, s.radius = capsule->radius;
  } else if (const auto* box = std::get_if<Box>(&shape)) {
    std::vector<Vector3> corners;
    for (const Real x : {-1, 1})
      for (const Real y : {-1, 1})
        for (const Real z : {-1, 1}) corners.emplace_back(box->half_extents.cwiseProduct(Vector3(x, y, z)));
    hull = make_hull(corners);
  } else {
    hull = std::get<Hull>(shape);
  }
  for (const Vector3& v : hull.vertices) s.vertices.push_back(place(v));
  for (const auto& face : hull.faces) {
    const auto at = [&](std::size_t k) {
      return s.vertices[static_cast<std::size_t>(face[k % face.size()])];
    };
    for (std::size_t k = 2; k < face.size(); ++k) s.triangles.push_back({at(0), at(k - 1), at(k)});
    for (std::size_t k = 0; k < face.size(); ++k)
      if (face[k] < face[(k + 1) % face.size()]) s.edges.push_back({at(k), at(k + 1)});
    s.normals.push_back((at(1) - at(0)).cross(at(2) - at(1)).normalized());
  }
  return s;
}

inline Real to_segment(const Vector3& x, const Vector3& p, const Vector3& q) {
  const Vector3 d = q - p;
  const Real t = d.squaredNorm() > 0 ? std::clamp((x - p).dot(d) / d.squaredNorm(), Real(0), Real(1)) : 0;
  return (x - p - t * d).norm();
}

inline Real to_triangle(const Vector3& x, const std::array<Vector3, 3>& t) {
  const Vector3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  bool inside = n.squaredNorm() > 0;
  for (std::size_t k = 0; k < 3; ++k) inside = inside && n.cross(t[(k + 1) % 3] - t[k]).dot(x - t[k]) >= 0;
  if (inside) return std::abs(n.normalized().dot(x - t[0]));
  return std::min({to_segment(x, t[0], t[1]), to_segment(x, t[1], t[2]), to_segment(x, t[2], t[0])});
}

// Ends against segments, and the common perpendicular where its feet are on both.
inline Real between_segments(const std::array<Vector3, 2>& e, const std::array<Vector3, 2>& f) {
  Real least = std::min({to_segment(e[0], f[0], f[1]), to_segment(e[1], f[0], f[1]),
                         to_segment(f[0], e[0], e[1]), to_segment(f[1], e[0], e[1])});
  const Vector3 u = e[1] - e[0], w = f[1] - f[0], n = u.cross(w), d = f[0] - e[0];
  if (n.squaredNorm() > 0) {
    const Real s = d.cross(w).dot(n) / n.squaredNorm(), t = d.cross(u).dot(n) / n.squaredNorm();
    if (s > 0 && s < 1 && t > 0 && t < 1) least = std::min(least, (e[0] + s * u - f[0] - t * w).norm());
  }
  return least;
}

inline Real along(const Vector3& n, const Solid& a, const Solid& b) {
  Real least = std::numeric_limits<Real>::infinity(), most = -least;
  for (const Vector3& x : a.vertices) least = std::min(least, n.dot(x));
  for (const Vector3& x : b.vertices) most = std::max(most, n.dot(x));
  return least - most;
}

/// All features against all features.
inline Real slow_gap(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose) {
  const Solid a = solid(body, pose), b = solid(other, other_pose);
  Real axis = -std::numeric_limits<Real>::infinity(), distance = -axis;
  for (const Vector3& n : a.normals) axis = std::max(axis, along(-n, a, b));
  for (const Vector3& n : b.normals) axis = std::max(axis, along(n, a, b));
  for (const auto& e : a.edges)
    for (const auto& f : b.edges) {
      const Vector3 n = (e[1] - e[0]).cross(f[1] - f[0]);
      if (n.norm() == 0) continue;
      axis = std::max({axis, along(n.normalized(), a, b), along(-n.normalized(), a, b)});
    }
  for (const auto& e : a.edges)
    for (const auto& f : b.edges) distance = std::min(distance, between_segments(e, f));
  for (const Vector3& x : a.vertices) {
    for (const auto& t : b.triangles) distance = std::min(distance, to_triangle(x, t));
    for (const auto& f : b.edges) distance = std::min(distance, to_segment(x, f[0], f[1]));
    for (const Vector3& y : b.vertices) distance = std::min(distance, (x - y).norm());
  }
  for (const Vector3& y : b.vertices) {
    for (const auto& t : a.triangles) distance = std::min(distance, to_triangle(y, t));
    for (const auto& e : a.edges) distance = std::min(distance, to_segment(y, e[0], e[1]));
  }
  // a point or a segment has no inside: without faces the distance is all
  const bool has_inside = !a.normals.empty() || !b.normals.empty();
  return (has_inside && axis < 0 ? axis : distance) - a.radius - b.radius;
}

}  // namespace cylon::engine::geometry_test
