// Contact manifolds: number, position and depth of points, and constant point ids.
#include "engine/geometry/manifold.h"

#include "tests/engine/geometry/geometry_shapes.h"

#include <gtest/gtest.h>

#include <set>

namespace cylon::engine {
namespace {

using namespace geometry_test;

const Matrix3 tilted = exponential({Real(0.3), Real(-0.7), Real(0.4)}).toRotationMatrix();

// Both poses of a pair, moved together to where nothing is parallel to an axis.
Pose general(const Pose& pose) {
  return {tilted * pose.position + Vector3(Real(0.4), Real(-1.3), Real(0.2)), tilted * pose.rotation};
}

Matrix3 about_y(Real angle) { return exponential({0, angle, 0}).toRotationMatrix(); }

// Of the convex hull of the points, across the normal.
Real covered_area(const Manifold& m) {
  std::vector<std::array<Real, 2>> flat;
  const Vector3 x = m.normal.cross(Vector3(Real(0.36), Real(0.48), Real(0.8))).normalized(),
                y = m.normal.cross(x);
  Real cx = 0, cy = 0;
  for (int k = 0; k < m.count; ++k) {
    const Vector3& p = m.points[static_cast<std::size_t>(k)].position;
    flat.push_back({x.dot(p), y.dot(p)});
    cx += flat.back()[0] / static_cast<Real>(m.count), cy += flat.back()[1] / static_cast<Real>(m.count);
  }
  std::sort(flat.begin(), flat.end(), [&](const auto& p, const auto& q) {
    return std::atan2(p[1] - cy, p[0] - cx) < std::atan2(q[1] - cy, q[0] - cx);
  });
  Real area = 0;
  for (std::size_t k = 0; k < flat.size(); ++k) {
    const auto &p = flat[k], &q = flat[(k + 1) % flat.size()];
    area += (p[0] * q[1] - p[1] * q[0]) / 2;
  }
  return area;
}

Shape as_hull(const Shape& shape) {
  std::vector<Vector3> corners;
  for (const Real x : {-1, 1})
    for (const Real y : {-1, 1})
      for (const Real z : {-1, 1})
        corners.emplace_back(std::get<Box>(shape).half_extents.cwiseProduct(Vector3(x, y, z)));
  return make_hull(corners);
}

// Side lengths 1 and 1.4, turned about the common normal; the common area by hand.
TEST(GeometryManifold, FaceContactCoversCommonArea) {
  const Shape square = Box{{Real(0.5), Real(0.4), Real(0.5)}}, plate = Box{{Real(0.7), Real(0.3), Real(0.7)}};
  struct Case {
    Vector3 shift;
    Real angle, area;
    int count;
  };
  const Real pi = Real(3.14159265358979323846);
  const Real half_octagon = Real(0.5) * std::sqrt(Real(2));  // corner of the square over the plate's side
  for (const Case& c : {Case{{Real(0.05), 0, Real(0.05)}, Real(0.3), 1, 4},  // all of the square
                        Case{{Real(0.6), 0, Real(0.3)}, 0, Real(0.6), 4},    // [0.1, 0.7] x [-0.2, 0.7]
                        Case{{Real(0.1), 0, Real(0.1)}, pi / 4, 1, 4}})      // the square hangs over
    for (const auto& [a, b] : {std::pair(square, plate), std::pair(as_hull(square), plate),
                               std::pair(square, as_hull(plate)), std::pair(as_hull(square), as_hull(plate))})
      for (const Real gap : {Real(0), Real(1e-12), Real(0.001), Real(-0.01)}) {
        const Pose p = general({c.shift + Vector3(0, Real(0.7) + gap, 0), about_y(c.angle)});
        const Pose q = general({Vector3::Zero(), about_y(0)});
        const Manifold m = manifold(a, p, b, q, Real(0.01));
        Real area = c.area;
        if (c.shift.x() == Real(0.6)) area = Real(0.6) * Real(0.9);
        if (c.angle == pi / 4) {
          const Real over = Real(0.1) + half_octagon - Real(0.7);  // two corners hang over by this
          area = 1 - 2 * over * over;
        }
        EXPECT_NEAR(covered_area(m), area, 64 * eps * 4) << c.angle << " " << gap;
        EXPECT_EQ(m.count, c.angle == pi / 4 ? 6 : c.count);
        EXPECT_NEAR((m.normal - tilted.col(1)).norm(), 0, 32 * eps);
        std::set<std::uint32_t> features;
        for (int k = 0; k < m.count; ++k) {
          const ContactPoint& point = m.points[static_cast<std::size_t>(k)];
          EXPECT_NEAR(point.gap, gap, 32 * eps * 3);
          EXPECT_NEAR(tilted.col(1).dot(point.position - q.position), Real(0.3) + gap / 2, 32 * eps * 3);
          features.insert(point.feature);
        }
        EXPECT_EQ(static_cast<int>(features.size()), m.count);
      }
}

TEST(GeometryManifold, KeepsPointIdsUnderSmallMotion) {
  const Shape a = Box{{Real(0.5), Real(0.4), Real(0.5)}};
  for (const auto& [shape, other] : {std::pair(a, Shape(Box{{Real(0.7), Real(0.3), Real(0.7)}})),
                                     std::pair(a, Shape(prism(12, Real(0.6), Real(0.3))))}) {
    Sequence random(5);
    std::vector<std::uint32_t> before;
    for (int step = 0; step < 20; ++step) {
      const Vector3 shift = Vector3(Real(0.13), Real(0.7), Real(0.29)) + Real(1e-5) * random.vector();
      const Matrix3 turn = exponential(Real(1e-5) * random.vector()).toRotationMatrix() * about_y(Real(0.4));
      const Manifold m = manifold(shape, general({shift, turn}), other, general({}), Real(0.01));
      std::vector<std::uint32_t> now;
      for (int k = 0; k < m.count; ++k) now.push_back(m.points[static_cast<std::size_t>(k)].feature);
      ASSERT_GE(m.count, 4);
      if (step > 0) {
        EXPECT_EQ(now, before);
      }
      before = now;
    }
  }
}

TEST(GeometryManifold, CrossingEdgesGiveOnePoint) {
  const Shape box = Box{{Real(0.5), Real(0.4), Real(0.6)}};
  const Real quarter = Real(3.14159265358979323846) / 4;
  // one edge up along z, the other edge down along x
  const Matrix3 up = exponential({0, 0, quarter}).toRotationMatrix();
  const Matrix3 down = about_y(Real(1.4)) * exponential({0, 0, quarter}).toRotationMatrix();
  const Real height = 2 * (Real(0.5) + Real(0.4)) * std::sqrt(Real(0.5));
  for (const Real gap : {Real(0), Real(0.002), Real(-0.02)}) {
    const Pose p = general({{0, height + gap, 0}, down}), q = general({Vector3::Zero(), up});
    const Manifold m = manifold(box, p, box, q, Real(0.01));
    ASSERT_EQ(m.count, 1);
    EXPECT_NEAR(m.points[0].gap, gap, 32 * eps * 3);
    // of two edges a length of 1.2: rounding of positions of size 4 over the length, twice
    EXPECT_NEAR((m.normal - tilted.col(1)).norm(), 0, 256 * eps);
  }
}

// A box let down on another by less than any rounding keeps its four corners, whichever axis wins.
TEST(GeometryManifold, RestingBoxesKeepAllCorners) {
  const Shape box = Box{{Real(0.5), Real(0.5), Real(0.5)}};
  Sequence random(8);
  for (int k = 0; k < 200; ++k) {
    const Real tiny = std::pow(Real(10), -4 - 6 * (random.next() + 1));
    const Matrix3 turn = exponential(tiny * random.vector()).toRotationMatrix();
    const Vector3 shift = tiny * random.vector() + Vector3(0, 1, 0);
    const Manifold m = manifold(box, general({shift, turn}), box, general({}), Real(0.005));
    EXPECT_GE(m.count, 4) << tiny;
    EXPECT_NEAR(covered_area(m), 1, 8 * tiny + 64 * eps) << tiny;
  }
}

TEST(GeometryManifold, OfAPlaneHasTheCornersWithinTheMargin) {
  const Plane floor{tilted.col(1), tilted.col(1).dot(Vector3(Real(0.4), Real(-1.3), Real(0.2)))};
  const Shape box = Box{{Real(0.5), Real(0.3), Real(0.6)}}, capsule = Capsule{Real(0.2), Real(0.7)};
  const Matrix3 lying = exponential({0, 0, Real(3.14159265358979323846) / 2}).toRotationMatrix();
  const Pose at = general({{Real(0.1), Real(0.301), Real(0.3)}, about_y(Real(0.7))});
  EXPECT_EQ(manifold(box, at, floor, 0).count, 0);
  EXPECT_EQ(manifold(box, at, floor, Real(0.01)).count, 4);
  EXPECT_EQ(manifold(box, at, floor, 1).count, 8);
  EXPECT_NEAR(covered_area(manifold(box, at, floor, Real(0.01))), Real(1.2), 64 * eps);
  EXPECT_EQ(manifold(capsule, general({{0, Real(0.201), 0}, lying}), floor, Real(0.01)).count, 2);
  EXPECT_EQ(manifold(capsule, general({{0, Real(0.905), 0}, about_y(1)}), floor, Real(0.01)).count, 1);
  EXPECT_EQ(manifold(Sphere{Real(0.2)}, general({{0, Real(0.205), 0}, about_y(1)}), floor, Real(0.01)).count,
            1);
  EXPECT_EQ(manifold(Shape{}, at, floor, 1).count, 0);
}

// A prism of 20 corners on a plane: at most 8 of them, and still most of its area.  Seven directions find
// corners within 9 degrees of them, so the hull holds a heptagon turned by up to that: more than 0.8 of it.
TEST(GeometryManifold, ReducesToOutermostAndDeepestPoints) {
  const Shape drum = prism(20, Real(0.5), Real(0.4));
  const Real whole = 10 * Real(0.25) * std::sin(Real(3.14159265358979323846) / 10);
  for (const Real lean : {Real(0), Real(0.01)}) {
    const Pose p = general({{0, Real(0.39), 0}, exponential({lean, 0, lean / 3}).toRotationMatrix()});
    const Plane floor{tilted.col(1), tilted.col(1).dot(general({}).position)};
    for (const Manifold& m :
         {manifold(drum, p, floor, Real(0.02)),
          manifold(drum, p, Box{{1, Real(0.5), 1}}, general({{0, Real(-0.5), 0}, about_y(0)}), Real(0.02))}) {
      EXPECT_GE(m.count, 7);
      EXPECT_GT(covered_area(m), Real(0.8) * whole);
      Real deepest = 1;
      for (int k = 0; k < m.count; ++k)
        deepest = std::min(deepest, m.points[static_cast<std::size_t>(k)].gap);
      EXPECT_NEAR(deepest, separation(drum, p, floor).gap, lean == 0 ? 64 * eps : Real(0.001));
    }
  }
}

TEST(GeometryManifold, LyingCapsuleHasTwoPoints) {
  const Matrix3 lying = exponential({0, 0, Real(3.14159265358979323846) / 2}).toRotationMatrix();
  const Shape capsule = Capsule{Real(0.2), Real(0.4)}, rod = Capsule{0, Real(0.4)};
  const Pose ground = general({{0, Real(-0.5), 0}, about_y(0)});
  for (const Shape& slab : {Shape(Box{{1, Real(0.5), 1}}), as_hull(Box{{1, Real(0.5), 1}})})
    for (const Real angle : {Real(0), Real(0.8)}) {
      const Manifold m =
          manifold(capsule, general({{0, Real(0.199), 0}, about_y(angle) * lying}), slab, ground, Real(0.01));
      ASSERT_EQ(m.count, 2);
      EXPECT_NEAR(m.points[0].gap, Real(-0.001), 64 * eps);
      EXPECT_NEAR((m.points[0].position - m.points[1].position).norm(), Real(0.8), 64 * eps);
      EXPECT_NEAR((m.normal - tilted.col(1)).norm(), 0, 32 * eps);
      EXPECT_EQ(
          manifold(rod, general({{0, Real(0.001), 0}, about_y(angle) * lying}), slab, ground, Real(0.01))
              .count,
          2);
      // half over the edge: the part that is over the slab
      const Manifold over =
          manifold(capsule, general({{1, Real(0.199), 0}, lying}), slab, ground, Real(0.01));
      ASSERT_EQ(over.count, 2);
      EXPECT_NEAR((over.points[0].position - over.points[1].position).norm(), Real(0.4), 64 * eps);
    }
  const Manifold side = manifold(capsule, general({{Real(0.1), Real(0.401), 0}, lying}), capsule,
                                 general({Vector3::Zero(), lying}), Real(0.01));
  ASSERT_EQ(side.count, 2);
  EXPECT_NEAR((side.points[0].position - side.points[1].position).norm(), Real(0.7), 64 * eps);
  const Manifold crossed = manifold(capsule, general({{0, Real(0.401), 0}, about_y(1) * lying}), capsule,
                                    general({Vector3::Zero(), lying}), Real(0.01));
  EXPECT_EQ(crossed.count, 1);
}

// For every pair: nothing beyond the margin, something within it; no point shallower than the margin, and the deepest
// as deep as the separation, but for the tenth of the margin that a face may be preferred by.
TEST(GeometryManifold, AgreesWithTheSeparationOverAllPairs) {
  Sequence random(17);
  int empty = 0, full = 0;
  for (const Named& body : shapes())
    for (const Named& other : shapes())
      for (int k = 0; k < 120; ++k) {
        const Real margin = k % 2 == 0 ? Real(0.05) : Real(0.01);
        const Real reach = bounding_radius(body.shape) + bounding_radius(other.shape) + Real(0.05);
        const Pose p{reach * random.vector(), random.rotation()}, q{Vector3::Zero(), random.rotation()};
        const Separation s = separation(body.shape, p, other.shape, q);
        const Manifold m = manifold(body.shape, p, other.shape, q, margin);
        const std::string label = body.name + " against " + other.name;
        (m.count == 0 ? empty : full) += 1;
        ASSERT_EQ(m.count > 0, s.gap < margin) << label;
        const Real rounding = 64 * eps * (reach + 1);
        Real least = margin;
        for (int i = 0; i < m.count; ++i) {
          const ContactPoint& point = m.points[static_cast<std::size_t>(i)];
          ASSERT_LT(point.gap, margin) << label;
          least = std::min(least, point.gap);
          ASSERT_TRUE(point.position.allFinite());
        }
        if (m.count == 0) continue;
        ASSERT_NEAR(m.normal.norm(), 1, 16 * eps) << label;
        ASSERT_GE(least, s.gap - Real(0.1) * margin - rounding) << label;
        ASSERT_LE(least, s.gap + Real(0.1) * margin + rounding) << label;
        const Manifold back = manifold(other.shape, q, body.shape, p, margin);
        ASSERT_EQ(back.count > 0, true) << label;
      }
  EXPECT_GT(empty, 300);
  EXPECT_GT(full, 300);
}

// A corner of an octahedron's edge over the rim of a cylinder: the face beside the edge, which is within a tenth of the
// margin of the separating plane, has two places over it, neither as deep.  The octahedron sank in by 4.7 mm.
TEST(GeometryManifold, OfAnEdgeBesideAFaceHasTheDeepestPlace) {
  std::vector<Vector3> corners;
  for (int axis = 0; axis < 3; ++axis)
    for (const Real sign : {-1, 1}) corners.push_back(sign * Real(0.5) * Vector3::Unit(axis));
  const Shape octahedron = make_hull(corners),
              cylinder = Frustum{Real(0.4), Real(0.4), Real(-0.25), Real(0.25)};
  const Quaternion turn(Real(0.880352), Real(-0.322170), Real(-0.003459), Real(-0.348101)),
      about_y(Real(0.998890), 0, Real(0.047109), 0);
  const Pose at{{Real(0.699225), Real(0.055335), Real(0.303985)}, turn.normalized().toRotationMatrix()},
      standing{Vector3::Zero(), about_y.normalized().toRotationMatrix()};
  const Real gap = separation(octahedron, at, cylinder, standing).gap;
  EXPECT_NEAR(gap, Real(-0.00467), Real(1e-5));
  for (const Real margin : {Real(0.001), Real(0.01), Real(0.1)}) {
    const Manifold found = manifold(octahedron, at, cylinder, standing, margin);
    Real least = margin;
    for (int k = 0; k < found.count; ++k)
      least = std::min(least, found.points[static_cast<std::size_t>(k)].gap);
    EXPECT_LE(least, gap + Real(0.1) * margin + 64 * eps) << margin;
  }
}

}  // namespace
}  // namespace cylon::engine
