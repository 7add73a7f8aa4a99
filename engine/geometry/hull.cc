#include "engine/geometry/hull.h"

#include "engine/geometry/orient.h"
#include "engine/geometry/triangle_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

namespace cylon::engine {
namespace {

using Point = Eigen::Vector3d;
using Face = std::vector<int>;
constexpr double eps = epsilon;
constexpr double jog = 16 * eps, flatness = 64 * eps;  // times the size

struct Cloud {
  std::vector<Point> points;  // distinct
  double size = 0;

  const Point& operator[](int i) const { return points[static_cast<std::size_t>(i)]; }
  int count() const { return static_cast<int>(points.size()); }
};

Cloud distinct(const std::vector<Vector3>& input) {
  for (const Vector3& x : input)
    if (!x.allFinite()) throw std::invalid_argument("hull: a coordinate is not a finite number");
  std::vector<int> order(input.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const auto less = [&](int i, int j) {
    const Vector3 &x = input[static_cast<std::size_t>(i)], &y = input[static_cast<std::size_t>(j)];
    return std::lexicographical_compare(x.data(), x.data() + 3, y.data(), y.data() + 3);
  };
  std::stable_sort(order.begin(), order.end(), less);
  order.erase(std::unique(order.begin(), order.end(), [&](int i, int j) { return !less(i, j); }),
              order.end());
  std::sort(order.begin(), order.end());
  Cloud cloud;
  for (const int i : order) cloud.points.push_back(input[static_cast<std::size_t>(i)].cast<double>());
  if (cloud.count() < 4) throw std::invalid_argument("hull: fewer than 4 distinct points");
  Point low = cloud[0], high = cloud[0];
  for (const Point& x : cloud.points) low = low.cwiseMin(x), high = high.cwiseMax(x);
  cloud.size = (high - low).norm();
  return cloud;
}

template <class Measure>
int farthest(const Cloud& cloud, Measure&& measure) {
  int best = 0;
  for (int i = 1; i < cloud.count(); ++i)
    if (measure(cloud[i]) > measure(cloud[best])) best = i;
  return best;
}

// Four points that span the cloud: far apart, far from the line, far from the plane.
std::array<int, 4> spanning(const Cloud& cloud) {
  const int a = farthest(cloud, [&](const Point& x) { return (x - cloud[0]).squaredNorm(); });
  const int b = farthest(cloud, [&](const Point& x) { return (x - cloud[a]).squaredNorm(); });
  const Point u = (cloud[b] - cloud[a]).normalized();
  const int c = farthest(cloud, [&](const Point& x) { return u.cross(x - cloud[a]).squaredNorm(); });
  const Point n = u.cross(cloud[c] - cloud[a]);
  const auto height = [&](const Point& x) { return std::abs(n.dot(x - cloud[a])); };
  const int d = farthest(cloud, height);
  if (n.norm() <= flatness * cloud.size || height(cloud[d]) <= flatness * cloud.size * n.norm())
    throw std::invalid_argument("hull: all points are in a plane");
  return {a, b, c, d};
}

// General position: every point is moved by less than `jog`, by a linear congruential sequence (D. Knuth's
// MMIX), the same on every machine.
std::vector<Point> jogged(const Cloud& cloud) {
  std::vector<Point> points = cloud.points;
  std::uint64_t state = 1;
  for (Point& x : points)
    for (int k = 0; k < 3; ++k) {
      state = state * 6364136223846793005U + 1442695040888963407U;
      x[k] += jog * cloud.size * (std::ldexp(static_cast<double>(state >> 11U), -53) - 0.5);
    }
  return points;
}

Point area_vector(const Cloud& cloud, const Face& face) {
  Point sum = Point::Zero();
  for (std::size_t k = 2; k < face.size(); ++k)
    sum += (cloud[face[k - 1]] - cloud[face[0]]).cross(cloud[face[k]] - cloud[face[0]]);
  return sum / 2;
}

// The corners of points in a plane, counter-clockwise about n; those within `tolerance` of the line between
// their neighbours are left out.  A. M. Andrew's monotone chain, Inf. Proc. Letters 9 (1979) 216.
Face corners(const Cloud& cloud, Face points, const Point& n, double tolerance) {
  int least = 0;
  n.cwiseAbs().minCoeff(&least);
  const Point x = n.cross(Point::Unit(least)).normalized(), y = n.cross(x);
  const Point& origin = cloud[points.front()];
  const auto flat_of = [&](int i) { return std::pair(x.dot(cloud[i] - origin), y.dot(cloud[i] - origin)); };
  std::sort(points.begin(), points.end(), [&](int i, int j) { return flat_of(i) < flat_of(j); });
  const auto turns_left = [&](int i, int j, int k) {
    const auto [ax, ay] = flat_of(i);
    const auto [bx, by] = flat_of(j);
    const auto [cx, cy] = flat_of(k);
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) > tolerance * std::hypot(cx - ax, cy - ay);
  };
  Face ring;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = ring.size();
    for (const int i : points) {
      while (ring.size() >= start + 2 && !turns_left(ring[ring.size() - 2], ring.back(), i)) ring.pop_back();
      ring.push_back(i);
    }
    ring.pop_back();
    std::reverse(points.begin(), points.end());
  }
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

// The faces: of each triangle's plane, the largest first, all points that are in it.
std::vector<Face> merged(const Cloud& cloud, const std::vector<std::array<int, 3>>& triangles,
                         const std::vector<int>& used, double tolerance) {
  const auto area = [&](const std::array<int, 3>& t) { return area_vector(cloud, {t[0], t[1], t[2]}); };
  std::vector<std::pair<double, std::array<int, 3>>> order;
  for (const auto& t : triangles) order.emplace_back(-area(t).norm(), t);
  std::sort(order.begin(), order.end());
  std::vector<Face> faces;
  std::vector<std::vector<char>> in_face;
  for (const auto& [minus_area, triangle] : order) {
    const auto& t = triangle;  // clang 14 lets no lambda see a structured binding
    const auto taken = [&](const std::vector<char>& in) {
      return in[static_cast<std::size_t>(t[0])] && in[static_cast<std::size_t>(t[1])] &&
             in[static_cast<std::size_t>(t[2])];
    };
    if (std::any_of(in_face.begin(), in_face.end(), taken)) continue;
    Face face = {t[0], t[1], t[2]};
    std::vector<char> in(cloud.points.size(), 0);
    for (int fit = 0; fit < 2; ++fit) {  // the polygon's plane is better known than the triangle's
      const Point n = area_vector(cloud, face).normalized();
      if (!n.allFinite()) break;
      Face members;
      std::fill(in.begin(), in.end(), 0);
      for (const int i : used)
        if (std::abs(n.dot(cloud[i] - cloud[face[0]])) <= tolerance) {
          members.push_back(i);
          in[static_cast<std::size_t>(i)] = 1;
        }
      if (members.size() < 3) break;
      face = corners(cloud, members, n, tolerance);
      if (face.size() < 3) break;
    }
    if (face.size() < 3) continue;  // a sliver on an edge
    const Point n = area_vector(cloud, face).normalized();
    const bool outermost = std::none_of(used.begin(), used.end(), [&](int i) {
      return !(n.dot(cloud[i] - cloud[face[0]]) <= 4 * tolerance);
    });
    if (!outermost) continue;
    faces.push_back(face);
    in_face.push_back(in);
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

// Every edge once each way, and Euler's V - E + F = 2: the faces of a polyhedron.
std::optional<Hull> assembled(const Cloud& cloud, const std::vector<Face>& faces,
                              const std::vector<int>& used) {
  std::map<std::pair<int, int>, int> left;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < faces[f].size(); ++k)
      if (!left.emplace(std::pair(faces[f][k], faces[f][(k + 1) % faces[f].size()]), static_cast<int>(f))
               .second)
        return {};
  if (used.size() + faces.size() != left.size() / 2 + 2) return {};
  std::vector<int> number(cloud.points.size(), -1);
  Hull hull;
  for (const int i : used) {
    number[static_cast<std::size_t>(i)] = static_cast<int>(hull.vertices.size());
    hull.vertices.push_back(cloud[i].cast<Real>());
  }
  for (const auto& [edge, face] : left) {
    const auto back = left.find({edge.second, edge.first});
    if (back == left.end()) return {};
    if (edge.first < edge.second)
      hull.edges.push_back({number[static_cast<std::size_t>(edge.first)],
                            number[static_cast<std::size_t>(edge.second)], face, back->second});
  }
  for (const Face& face : faces) {
    hull.normals.push_back(area_vector(cloud, face).normalized().cast<Real>());
    Face renumbered;
    for (const int i : face) renumbered.push_back(number[static_cast<std::size_t>(i)]);
    hull.faces.push_back(renumbered);
  }
  return hull;
}

std::optional<Hull> hull_within(const Cloud& cloud, const std::vector<std::array<int, 3>>& triangles,
                                double tolerance) {
  std::vector<int> used;
  for (const auto& t : triangles) used.insert(used.end(), t.begin(), t.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  while (used.size() >= 4) {
    const std::vector<Face> faces = merged(cloud, triangles, used, tolerance);
    std::vector<int> times(cloud.points.size(), 0);
    for (const Face& face : faces)
      for (const int i : face) ++times[static_cast<std::size_t>(i)];
    // a corner has three faces; what has fewer lies on an edge or in a face
    const auto end = std::remove_if(used.begin(), used.end(),
                                    [&](int i) { return times[static_cast<std::size_t>(i)] < 3; });
    if (end == used.end()) return assembled(cloud, faces, used);
    used.erase(end, used.end());
  }
  return {};
}

// A triangle has none.
Real half_width(const Hull& hull) {
  const auto vertex = [&](int i) { return hull.vertices[static_cast<std::size_t>(i)]; };
  Real least = std::numeric_limits<Real>::max(), most = 0;
  for (const auto& face : hull.faces) {
    const Vector3 p = vertex(face[0]), q = vertex(face[1]), r = vertex(face[2]);
    const Vector3 n = (q - p).cross(r - p).normalized();
    Real depth = 0;
    for (const Vector3& v : hull.vertices) depth = std::max(depth, n.dot(p - v));
    least = std::min(least, depth / 2), most = std::max(most, (q - p).norm());
  }
  return least > 16 * epsilon * most ? least : 0;
}

}  // namespace

Hull make_hull(const std::vector<Vector3>& points) {
  const Cloud cloud = distinct(points);
  const std::array<int, 4> first = spanning(cloud);
  const auto triangles = triangle_hull(jogged(cloud), first);
  // Wider tolerances for clouds whose points are in a plane but for noise above rounding.
  for (double tolerance = flatness; tolerance < std::sqrt(eps); tolerance *= 4)
    if (auto hull = hull_within(cloud, triangles, tolerance * cloud.size)) {
      hull->half_width = half_width(*hull);
      return *std::move(hull);
    }
  throw std::invalid_argument("hull: points are too nearly in a plane, in a line or the same");
}

Hull make_triangle(const std::array<Vector3, 3>& corners) {
  Hull hull;
  hull.vertices.assign(corners.begin(), corners.end());
  const Vector3 n = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  hull.faces = {{0, 1, 2}, {0, 2, 1}};
  hull.normals = {n, -n};
  hull.edges = {{0, 1, 0, 1}, {1, 2, 0, 1}, {2, 0, 0, 1}};
  return hull;
}

bool is_convex(const std::vector<Vector3>& vertices, const std::vector<std::array<int, 3>>& triangles) {
  std::map<std::pair<int, int>, int> times;
  Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] < 0 || t[k] >= static_cast<int>(vertices.size())) return false;
      if (++times[{t[k], t[(k + 1) % 3]}] > 1) return false;
      const Point x = vertices[static_cast<std::size_t>(t[k])].cast<double>();
      low = low.cwiseMin(x), high = high.cwiseMax(x);
    }
  if (triangles.size() < 4) return false;
  for (const auto& [edge, count] : times)
    if (times.find({edge.second, edge.first}) == times.end()) return false;
  const double tolerance = flatness * (high - low).norm();
  std::set<int> corners;
  for (const auto& t : triangles) corners.insert(t.begin(), t.end());
  for (const auto& t : triangles) {
    const auto at = [&](std::size_t k) {
      return Point(vertices[static_cast<std::size_t>(t[k])].cast<double>());
    };
    const Point n = (at(1) - at(0)).cross(at(2) - at(0));
    const double longest = std::max({(at(1) - at(0)).norm(), (at(2) - at(0)).norm(), (at(2) - at(1)).norm()});
    // the plane of a sliver is known to `tolerance` over its height, n/longest, at the distance of the size
    const double slack = tolerance * (n.norm() + longest * longest);
    for (const int i : corners)
      if (!(n.dot(vertices[static_cast<std::size_t>(i)].cast<double>() - at(0)) <= slack)) return false;
  }
  return true;
}

}  // namespace cylon::engine
