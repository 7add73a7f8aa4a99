// Hulls: Euler's formula, contained points, volume; and which meshes are convex.
#include "engine/geometry/hull.h"

#include "tests/engine/geometry/geometry_shapes.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace cylon::engine {
namespace {

using namespace geometry_test;

Real volume(const Hull& hull) {
  Real sum = 0;
  for (const auto& face : hull.faces) {
    const auto at = [&](std::size_t k) { return hull.vertices[static_cast<std::size_t>(face[k])]; };
    for (std::size_t k = 2; k < face.size(); ++k) sum += at(0).dot(at(k - 1).cross(at(k))) / 6;
  }
  return sum;
}

void expect_polyhedron(const Hull& hull, const std::vector<Vector3>& points, Real size) {
  const auto v = hull.vertices.size(), e = hull.edges.size(), f = hull.faces.size();
  EXPECT_EQ(v + f, e + 2);
  ASSERT_EQ(hull.normals.size(), f);
  std::set<std::pair<int, int>> half_edges;
  for (const auto& face : hull.faces)
    for (std::size_t k = 0; k < face.size(); ++k)
      EXPECT_TRUE(half_edges.emplace(face[k], face[(k + 1) % face.size()]).second);
  EXPECT_EQ(half_edges.size(), 2 * e);
  for (std::size_t i = 0; i < f; ++i) {
    EXPECT_NEAR(hull.normals[i].norm(), 1, 8 * eps);
    const Vector3 on = hull.vertices[static_cast<std::size_t>(hull.faces[i][0])];
    // dropped points are within 64 eps of the hull, vertices of a face within 64 eps of its plane
    for (const Vector3& x : points) EXPECT_LE(hull.normals[i].dot(x - on), 256 * eps * size);
    for (const int k : hull.faces[i])
      EXPECT_NEAR(hull.normals[i].dot(hull.vertices[static_cast<std::size_t>(k)] - on), 0, 256 * eps * size);
  }
  for (const auto& [from, to, left, right] : hull.edges) {
    const auto has = [&](int face, int a, int b) {
      const auto& ring = hull.faces[static_cast<std::size_t>(face)];
      for (std::size_t k = 0; k < ring.size(); ++k)
        if (ring[k] == a && ring[(k + 1) % ring.size()] == b) return true;
      return false;
    };
    EXPECT_TRUE(has(left, from, to) && has(right, to, from));
  }
}

// By all triples of points that have all others on one side.
Real slow_volume(const std::vector<Vector3>& points) {
  Real sum = 0;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k) {
        const Vector3 normal = (points[j] - points[i]).cross(points[k] - points[i]);
        int above = 0, below = 0;
        for (const Vector3& x : points) {
          const Real height = normal.dot(x - points[i]);
          above += height > 0 && &x != &points[j] && &x != &points[k];
          below += height < 0 && &x != &points[j] && &x != &points[k];
        }
        if (above == 0 || below == 0) sum += std::abs(normal.dot(points[i])) / 6;
      }
  return sum;
}

TEST(GeometryHull, HullOfRandomPointsContainsThem) {
  for (const int count : {4, 5, 8, 25, 60, 400}) {
    Sequence random(static_cast<std::uint64_t>(count));
    std::vector<Vector3> points;
    for (int i = 0; i < count; ++i) points.emplace_back(random.vector() + Vector3(5, -3, 2));
    expect_polyhedron(make_hull(points), points, 10);
  }
}

// The origin is inside: the volume is the sum of cones over the faces.
TEST(GeometryHull, HasTheVolumeOfItsPoints) {
  for (const int count : {12, 20, 30}) {
    Sequence random(static_cast<std::uint64_t>(count));
    std::vector<Vector3> points;
    for (int i = 0; i < count; ++i) points.push_back(random.direction());
    EXPECT_NEAR(volume(make_hull(points)), slow_volume(points), 256 * eps * 4) << count;
  }
}

// Every way in which points can lie in the planes and lines of others; turned, so that rounding has its say.
TEST(GeometryHull, HullOfLatticeIsBox) {
  for (const Vector3& turn :
       {Vector3(0, 0, 0), Vector3(Real(0.3), Real(-0.7), Real(0.4)), Vector3(2, 1, -1)}) {
    const Matrix3 r = exponential(turn).toRotationMatrix();
    std::vector<Vector3> points;
    for (int x = -2; x <= 2; ++x)
      for (int y = -2; y <= 2; ++y)
        for (int z = -2; z <= 2; ++z)
          points.emplace_back(r * Vector3(Real(0.5) * x, Real(0.3) * y, Real(0.7) * z));
    const Hull hull = make_hull(points);
    EXPECT_EQ(hull.vertices.size(), 8u);
    EXPECT_EQ(hull.faces.size(), 6u);
    EXPECT_NEAR(volume(hull), 2 * Real(1.2) * Real(2.8), 100 * eps * 7);
    expect_polyhedron(hull, points, 5);
  }
}

TEST(GeometryHull, MergesTheTrianglesOfAPrism) {
  for (const int corners : {3, 5, 12, 64}) {
    const Hull hull = prism(corners, Real(0.7), Real(0.4));
    EXPECT_EQ(hull.vertices.size(), static_cast<std::size_t>(2 * corners));
    EXPECT_EQ(hull.faces.size(), static_cast<std::size_t>(corners + 2));
    expect_polyhedron(hull, hull.vertices, 2);
  }
}

TEST(GeometryHull, KeepsThinAndSmallHulls) {
  Sequence random(9);
  for (const Vector3& scale : {Vector3(1, Real(1e-4), 1), Vector3(1, Real(1e-4), Real(1e-4)),
                               Vector3(Real(1e-5), Real(1e-5), Real(1e-5)), Vector3(1000, 2000, 500)}) {
    std::vector<Vector3> points;
    for (int i = 0; i < 40; ++i) points.emplace_back(random.direction().cwiseProduct(scale));
    expect_polyhedron(make_hull(points), points, 2 * scale.maxCoeff());
  }
}

TEST(GeometryHull, IsTheSameForTheSamePoints) {
  const Hull a = cloud_hull(80, 5), b = cloud_hull(80, 5);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.normals, b.normals);
}

TEST(GeometryHull, GivesReasonForNoHull) {
  const auto reason = [](const std::vector<Vector3>& points) -> std::string {
    try {
      make_hull(points);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "made";
  };
  const Vector3 a(1, 2, 3), b(2, 1, 0), c(0, 1, 1), d(5, 2, 7);
  EXPECT_EQ(reason({a, b, c, d}), "made");
  EXPECT_EQ(reason({}), "hull: fewer than 4 distinct points");
  EXPECT_EQ(reason({a, b, c}), "hull: fewer than 4 distinct points");
  EXPECT_EQ(reason({a, b, c, a, b}), "hull: fewer than 4 distinct points");
  EXPECT_EQ(reason({a, b, c, (a + b) / 2, (a + c) / 3 + b / 3}), "hull: all points are in a plane");
  EXPECT_EQ(reason({a, 2 * a, 3 * a, 5 * a}), "hull: all points are in a plane");
  EXPECT_EQ(reason({a, b, c, {1, std::numeric_limits<Real>::quiet_NaN(), 0}}),
            "hull: a coordinate is not a finite number");
}

using Triangles = std::vector<std::array<int, 3>>;

Triangles triangles(const Hull& hull) {
  Triangles result;
  for (const auto& face : hull.faces)
    for (std::size_t k = 2; k < face.size(); ++k) result.push_back({face[0], face[k - 1], face[k]});
  return result;
}

TEST(GeometryConvex, RecognizesConvexMeshes) {
  const Matrix3 turn = exponential({Real(0.3), Real(-0.7), Real(0.4)}).toRotationMatrix();
  for (const Hull& hull : {prism(4, 1, Real(0.5)), prism(20, 1, Real(0.01)), cloud_hull(50, 3)}) {
    std::vector<Vector3> vertices;
    for (const Vector3& x : hull.vertices) vertices.emplace_back(turn * x + Vector3(Real(0.3), 1, -2));
    Triangles mesh = triangles(hull);
    EXPECT_TRUE(is_convex(vertices, mesh));

    Triangles open(mesh.begin(), mesh.end() - 1), inside_out = mesh, one_flipped = mesh;
    for (auto& t : inside_out) std::swap(t[1], t[2]);
    std::swap(one_flipped[0][1], one_flipped[0][2]);
    EXPECT_FALSE(is_convex(vertices, open));
    EXPECT_FALSE(is_convex(vertices, inside_out));
    EXPECT_FALSE(is_convex(vertices, one_flipped));

    std::vector<Vector3> dented = vertices;
    Vector3 middle = Vector3::Zero();
    for (const Vector3& x : vertices) middle += x / static_cast<Real>(vertices.size());
    dented[1] += Real(0.9) * (middle - dented[1]);
    EXPECT_FALSE(is_convex(dented, mesh));
  }
}

// The seed takes a body for convex where the centre of mass is inside; that of a thick L is, and it is not
// convex (errata 37).
TEST(GeometryConvex, LShapeIsNotConvex) {
  const std::vector<std::array<Real, 2>> outline = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  std::vector<Vector3> vertices;
  for (const Real z : {0, 1})
    for (const auto& [x, y] : outline) vertices.emplace_back(x, y, z);
  Triangles mesh;
  const Triangles cap = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  for (const auto& [a, b, c] : cap) mesh.push_back({a, c, b}), mesh.push_back({a + 6, b + 6, c + 6});
  for (int i = 0; i < 6; ++i) {
    const int j = (i + 1) % 6;
    mesh.push_back({i, j, j + 6}), mesh.push_back({i, j + 6, i + 6});
  }
  EXPECT_FALSE(is_convex(vertices, mesh));
  vertices[3] = {Real(1.5), Real(1.5), 0}, vertices[9] = {Real(1.5), Real(1.5), 1};  // the notch filled up
  EXPECT_TRUE(is_convex(vertices, mesh));
}

}  // namespace
}  // namespace cylon::engine
