#include "harness/core/polyhedron.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace cylon::core {
namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;

void require_closed(std::size_t vertices, const std::vector<Triangle>& faces) {
  std::map<Edge, int> edges;
  for (const Triangle& face : faces)
    for (std::size_t i = 0; i < 3; ++i) {
      if (face[i] < 0 || static_cast<std::size_t>(face[i]) >= vertices)
        throw std::invalid_argument(fmt::format("a face refers to vertex {} of {}", face[i], vertices));
      ++edges[{face[i], face[(i + 1) % 3]}];
    }
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end())
      throw std::invalid_argument(
          fmt::format("the mesh is not closed: edge {}-{} is not shared by two faces of one sense",
                      edge.first, edge.second));
  }
}

// Twice the area vector of a triangle.
Vector3 normal(const std::vector<Vector3>& p, const Triangle& t) {
  const Vector3 &a = p[static_cast<std::size_t>(t[0])], &b = p[static_cast<std::size_t>(t[1])],
                &c = p[static_cast<std::size_t>(t[2])];
  return (b - a).cross(c - a);
}

// Four points that span a volume, each the farthest from those before it; as a positive tetrahedron.
std::array<std::int32_t, 4> first_tetrahedron(const std::vector<Vector3>& p) {
  const auto farthest = [&](auto distance) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < p.size(); ++i)
      if (distance(p[i]) > distance(p[best])) best = i;
    return best;
  };
  if (p.size() < 4) throw std::invalid_argument("a hull needs four points or more");
  const std::size_t a = 0;
  const std::size_t b = farthest([&](const Vector3& x) { return (x - p[a]).norm(); });
  const Vector3 line = p[b] - p[a];
  const std::size_t c = farthest([&](const Vector3& x) { return line.cross(x - p[a]).norm(); });
  const Vector3 up = line.cross(p[c] - p[a]);
  const std::size_t d = farthest([&](const Vector3& x) { return std::abs(up.dot(x - p[a])); });
  const double volume = up.dot(p[d] - p[a]), size = line.norm();
  if (!(std::abs(volume) > 1e-12 * size * size * size))
    throw std::invalid_argument("the points lie in one plane, so their hull has no volume");
  const auto i = [](std::size_t k) { return static_cast<std::int32_t>(k); };
  return volume > 0 ? std::array{i(a), i(c), i(b), i(d)} : std::array{i(a), i(b), i(c), i(d)};
}

}  // namespace

// With tetrahedra from the origin to each face (a, b, c), v = a . (b x c) / 6:
//   V = sum v,   V centre = sum v (a + b + c) / 4,
//   integral of x x^T = C = sum v/20 (s s^T + a a^T + b b^T + c c^T), s = a + b + c,
//   I = tr(C) 1 - C.
// The origin is put at the vertices' mean, so that nothing large cancels.
Solid solid(const std::vector<Vector3>& vertices, const std::vector<Triangle>& faces) {
  require_closed(vertices.size(), faces);
  Vector3 mean = Vector3::Zero();
  for (const Vector3& vertex : vertices) mean += vertex / static_cast<double>(vertices.size());
  double volume = 0;
  Vector3 first = Vector3::Zero();
  Matrix3 second = Matrix3::Zero();
  for (const Triangle& face : faces) {
    const Vector3 a = vertices[static_cast<std::size_t>(face[0])] - mean;
    const Vector3 b = vertices[static_cast<std::size_t>(face[1])] - mean;
    const Vector3 c = vertices[static_cast<std::size_t>(face[2])] - mean;
    const Vector3 s = a + b + c;
    const double v = a.dot(b.cross(c)) / 6;
    volume += v;
    first += v / 4 * s;
    second += v / 20 * (s * s.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
  }
  if (!(volume > 0) || !std::isfinite(volume))
    throw std::invalid_argument(
        fmt::format("the mesh has the volume {} m^3; its faces must be counter-clockwise "
                    "seen from outside",
                    volume));
  const Vector3 offset = first / volume;
  second -= volume * offset * offset.transpose();
  return {volume, mean + offset, second.trace() * Matrix3::Identity() - second};
}

// Point by point: the faces that see the new point go, and their rim is joined to it.  Points within 1e-9 of
// the size of one before, or of the surface, add nothing; slivers between them would have no normal.
std::vector<Triangle> convex_hull(const std::vector<Vector3>& p) {
  const auto [a, b, c, d] = first_tetrahedron(p);
  std::vector<Triangle> faces = {{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}};
  std::vector<std::int32_t> kept_points = {a, b, c, d};
  double size = 0;
  for (const Vector3& x : p) size = std::max(size, (x - p[0]).norm());
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(p.size()); ++i) {
    const auto known = [&](std::int32_t j) {
      return (p[static_cast<std::size_t>(i)] - p[static_cast<std::size_t>(j)]).norm() <= 1e-9 * size;
    };
    if (std::ranges::any_of(kept_points, known)) continue;
    kept_points.push_back(i);
    const auto sees = [&](const Triangle& t) {
      const Vector3 n = normal(p, t);
      return n.dot(p[static_cast<std::size_t>(i)] - p[static_cast<std::size_t>(t[0])]) >
             1e-9 * size * n.norm();
    };
    std::set<Edge> rim;
    std::vector<Triangle> kept;
    for (const Triangle& t : faces) {
      if (!sees(t)) {
        kept.push_back(t);
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const Edge edge{t[k], t[(k + 1) % 3]};
        if (!rim.erase({edge.second, edge.first})) rim.insert(edge);
      }
    }
    for (const Edge& edge : rim) kept.push_back({edge.first, edge.second, i});
    faces = std::move(kept);
  }
  return faces;
}

}  // namespace cylon::core
