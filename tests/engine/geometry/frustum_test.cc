// Cylinders and cones: depth and normal against support functions alone, symmetries, manifolds.
#include "engine/geometry/manifold.h"
#include "tests/engine/geometry/geometry_shapes.h"

#include <gtest/gtest.h>

namespace cylon::engine {
namespace {

using namespace geometry_test;

const std::vector<Named> round_shapes = {
    {"cylinder", Frustum{Real(0.4), Real(0.4), Real(-0.3), Real(0.3)}},
    {"coin", Frustum{Real(0.5), Real(0.5), Real(-0.02), Real(0.02)}},
    {"cone", Frustum{Real(0.4), 0, Real(-0.15), Real(0.45)}},
    {"funnel", Frustum{0, Real(0.3), Real(-0.5), Real(0.2)}},
    {"bucket", Frustum{Real(0.25), Real(0.4), Real(-0.3), Real(0.3)}},
};

// By formulas of their own: max of d.x over the shape.
Real reach(const Shape& shape, const Pose& pose, const Vector3& d) {
  const Vector3 own = pose.rotation.transpose() * d;
  if (const auto* s = std::get_if<Frustum>(&shape)) {
    const Real across = std::sqrt(own.x() * own.x() + own.z() * own.z());
    return d.dot(pose.position) +
           std::max(s->low_radius * across + s->low * own.y(), s->high_radius * across + s->high * own.y());
  }
  const Solid s = solid(shape, pose);
  Real most = -std::numeric_limits<Real>::infinity();
  for (const Vector3& x : s.vertices) most = std::max(most, d.dot(x));
  return most + s.radius * d.norm();
}

Real between(const Shape& a, const Pose& p, const Shape& b, const Pose& q, const Vector3& n) {
  return -reach(a, p, -n) - reach(b, q, n);
}

struct Case {
  const Named &body, &other;
  Pose pose, other_pose;
  std::string label() const { return body.name + " against " + other.name; }
};

// Turned at random, the gap within 0.05 of zero.
template <class Check>
void near_contact(int poses, Check&& check) {
  Sequence random(17);
  std::vector<Named> others = shapes();
  others.insert(others.end(), round_shapes.begin(), round_shapes.end());
  for (const Named& body : round_shapes)
    for (const Named& other : others)
      for (int k = 0; k < poses; ++k) {
        Case c{body, other, {}, {}};
        c.pose = {random.vector(), random.rotation()};
        c.other_pose = {c.pose.position, random.rotation()};
        const Vector3 way = random.direction();
        Real low = 0, high = 3;
        for (int i = 0; i < 16; ++i) {
          const Real middle = (low + high) / 2;
          c.other_pose.position = c.pose.position + middle * way;
          (separation(body.shape, c.pose, other.shape, c.other_pose).gap > 0 ? high : low) = middle;
        }
        c.other_pose.position =
            c.pose.position + (high + Real(k % 2 == 0 ? 0.05 : -0.002) * std::abs(random.next())) * way;
        check(c);
      }
}

// The gap is what the plane with the found normal leaves, and no other plane near it leaves more.
TEST(GeometryFrustum, GapIsThatOfTheWidestPlane) {
  constexpr Real tolerance = eps < Real(1e-10) ? Real(1e-5) : Real(1e-3);
  Sequence random(5);
  int exact = 0, all = 0, overlapping = 0;
  near_contact(8, [&](const Case& c) {
    const Separation s = separation(c.body.shape, c.pose, c.other.shape, c.other_pose);
    const Real plane = between(c.body.shape, c.pose, c.other.shape, c.other_pose, s.normal);
    EXPECT_NEAR(s.gap, plane, tolerance) << c.label();
    ++all, exact += std::abs(s.gap - plane) < Real(1e-10), overlapping += s.gap < 0;
    for (int k = 0; k < 8; ++k) {
      const Vector3 n = (s.normal + Real(0.01) * random.vector()).normalized();
      EXPECT_LT(between(c.body.shape, c.pose, c.other.shape, c.other_pose, n), s.gap + tolerance)
          << c.label();
    }
    EXPECT_NEAR((s.point - s.other_point - s.gap * s.normal).norm(), 0, tolerance) << c.label();
  });
  EXPECT_GT(exact, all * 9 / 10) << all;  // rims against edges and rims take up to 1e-6
  EXPECT_GT(overlapping, all / 3);
}

// What Manifold::unsettled promises.
TEST(GeometryFrustum, TellsByHowMuchTheGapMayBeOff) {
  int unsettled = 0, all = 0;
  near_contact(20, [&](const Case& c) {
    const Manifold m = manifold(c.body.shape, c.pose, c.other.shape, c.other_pose, 1);
    const Separation s = separation(c.body.shape, c.pose, c.other.shape, c.other_pose);
    const Real plane = between(c.body.shape, c.pose, c.other.shape, c.other_pose, s.normal);
    EXPECT_LT(s.gap - plane, m.unsettled + (eps < Real(1e-10) ? Real(1e-13) : Real(1e-5))) << c.label();
    ++all, unsettled += m.unsettled > 0;
  });
  EXPECT_LT(unsettled, all / 20) << all;
}

TEST(GeometryFrustum, IsTheSameForEitherOrderAndAfterACommonMotion) {
  Sequence random(9);
  near_contact(3, [&](const Case& c) {
    const Separation s = separation(c.body.shape, c.pose, c.other.shape, c.other_pose);
    const Separation back = separation(c.other.shape, c.other_pose, c.body.shape, c.pose);
    EXPECT_NEAR(s.gap, back.gap, Real(1e-5)) << c.label();
    const Matrix3 r = random.rotation();
    const Vector3 d = random.vector();
    const Separation there =
        separation(c.body.shape, {r * c.pose.position + d, r * c.pose.rotation}, c.other.shape,
                   {r * c.other_pose.position + d, r * c.other_pose.rotation});
    EXPECT_NEAR(s.gap, there.gap, Real(1e-5)) << c.label();
  });
}

// Placed by hand: the gap is known.
TEST(GeometryFrustum, KnownPlacesAreExact) {
  const Frustum can{Real(0.4), Real(0.4), Real(-0.3), Real(0.3)};
  const Box box{{Real(0.5), Real(0.25), Real(0.7)}};
  const Sphere ball{Real(0.2)};
  const Matrix3 turn = exponential({Real(0.3), Real(-0.7), Real(0.4)}).toRotationMatrix();
  const Matrix3 lies = exponential({Real(1.5707963267948966), 0, 0}).toRotationMatrix();  // axis along z
  const Matrix3 about = exponential({0, Real(0.37), 0}).toRotationMatrix();
  struct Row {
    const char* name;
    Shape a, b;
    Vector3 from_b;
    Matrix3 turn_a;
    Real gap;
    Vector3 normal;
  };
  const Row rows[] = {
      {"cap on face",
       can,
       box,
       {Real(0.05), Real(0.25 + 0.3 + 0.01), Real(0.02)},
       about,
       Real(0.01),
       {0, 1, 0}},
      {"side on face",
       can,
       box,
       {Real(0.05), Real(0.25 + 0.4 - 0.01), Real(0.1)},
       Matrix3(about * lies),
       Real(-0.01),
       {0, 1, 0}},
      {"ball at side",
       can,
       ball,
       {Real(0.6 * 0.6 + 0.006), Real(0.1), Real(0.8 * 0.6 + 0.008)},
       about,
       Real(0.01),
       {Real(0.6), 0, Real(0.8)}},
      {"ball over cap", can, ball, {Real(0.11), Real(-0.53), Real(0.2)}, about, Real(0.03), {0, -1, 0}},
      {"sides cross", can, can, {Real(0.85), Real(0.1), Real(-0.1)}, lies, Real(0.05), {1, 0, 0}},
  };
  for (const Row& row : rows) {
    const Pose b{{Real(0.4), Real(-1.3), Real(0.2)}, turn};
    const Pose a{b.position + turn * row.from_b, turn * row.turn_a};
    const Separation s = separation(row.a, a, row.b, b);
    EXPECT_NEAR(s.gap, row.gap, Real(1e-13)) << row.name;
    EXPECT_NEAR((s.normal - turn * row.normal).norm(), 0, Real(1e-7)) << row.name;
  }
}

TEST(GeometryFrustum, ManifoldsHoldWhatStandsAndWhatLies) {
  const Frustum can{Real(0.4), Real(0.4), Real(-0.3), Real(0.3)};
  const Box box{{2, Real(0.25), 2}};
  const Plane plane{{0, 1, 0}, Real(0.25)};
  const Matrix3 about = exponential({0, Real(0.37), 0}).toRotationMatrix();
  const Matrix3 lies = about * exponential({Real(1.5707963267948966), 0, 0}).toRotationMatrix();
  const Matrix3 leans = exponential({Real(1e-3), 0, Real(0.4e-3)}).toRotationMatrix() * about;
  struct Row {
    const char* name;
    Real height;
    Matrix3 turn;
    int least, most;
  };
  const Row rows[] = {{"stands", Real(0.25 + 0.3), about, 5, 8},
                      {"lies", Real(0.25 + 0.4), lies, 2, 2},
                      {"leans", Real(0.25 + 0.3), leans, 5, 8}};
  for (const Row& row : rows)
    for (const bool on_plane : {false, true}) {
      const Pose pose{{Real(0.1), row.height, Real(-0.2)}, row.turn};
      const Manifold m = on_plane ? manifold(Shape(can), pose, plane, Real(0.01))
                                  : manifold(Shape(can), pose, Shape(box), {}, Real(0.01));
      EXPECT_GE(m.count, row.least) << row.name << on_plane;
      EXPECT_LE(m.count, row.most) << row.name << on_plane;
      EXPECT_NEAR((m.normal - Vector3::UnitY()).norm(), 0, Real(1e-12)) << row.name << on_plane;
      Real deepest = 1;
      for (int k = 0; k < m.count; ++k)
        deepest = std::min(deepest, m.points[static_cast<std::size_t>(k)].gap);
      EXPECT_NEAR(deepest, separation(Shape(can), pose, plane).gap, Real(1e-13)) << row.name << on_plane;
    }
}

}  // namespace
}  // namespace cylon::engine
