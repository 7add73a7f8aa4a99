// The bound that prevents tunnelling: no motion within the speed limits makes the shapes touch earlier.
#include "engine/geometry/advance.h"

#include "tests/engine/geometry/geometry_shapes.h"

#include <gtest/gtest.h>

namespace cylon::engine {
namespace {

using namespace geometry_test;

struct Flight {
  Pose start;
  Vector3 velocity, spin;
  Pose at(Real t) const {
    return {start.position + t * velocity, exponential(t * spin).toRotationMatrix() * start.rotation};
  }
};

TEST(GeometryAdvance, NeverOverstepsAnImpact) {
  Sequence random(23);
  int met = 0;
  for (const Named& body : shapes())
    for (const Named& other : shapes())
      for (int k = 0; k < 12; ++k) {
        const Flight a{{3 * random.vector(), random.rotation()}, 4 * random.vector(), 9 * random.vector()};
        const Flight b{{Vector3::Zero(), random.rotation()}, 2 * random.vector(), 5 * random.vector()};
        const Real radius_a = bounding_radius(body.shape), radius_b = bounding_radius(other.shape);
        const Separation s = separation(body.shape, a.at(0), other.shape, b.at(0));
        const Real within =
            safe_time(s, {a.velocity, 0, a.spin.norm(), radius_a}, {b.velocity, 0, b.spin.norm(), radius_b});
        const Real blind = safe_time(s.gap, (a.velocity - b.velocity).norm(), a.spin.norm(), radius_a,
                                     b.spin.norm(), radius_b);
        if (s.gap <= 0) {
          ASSERT_EQ(within, 0);
          continue;
        }
        ASSERT_GE(within, blind);
        ++met;
        for (int i = 1; i <= 20; ++i) {
          const Real t = std::min(within, Real(10)) * static_cast<Real>(i) / 20;
          const Real gap = separation(body.shape, a.at(t), other.shape, b.at(t)).gap;
          ASSERT_GE(gap, -64 * eps * (10 + 10 * t)) << body.name << " against " << other.name << " at " << t;
        }
      }
  EXPECT_GT(met, 500);
}

// A needle shot through a thin wall: advanced again and again it arrives at the wall and stops there.
TEST(GeometryAdvance, FastBodyDoesNotPassThinWall) {
  const Shape wall = Box{{2, Real(0.001), 2}}, bullet = Capsule{Real(0.004), Real(0.01)};
  const Vector3 velocity(30, -900, 20), spin(300, 20, -100);
  const Flight flight{
      {{Real(-0.3), 5, Real(0.2)}, exponential({1, 2, 3}).toRotationMatrix()}, velocity, spin};
  Real t = 0;
  int steps = 0;
  for (; steps < 200; ++steps) {
    const Separation s = separation(bullet, flight.at(t), wall, {});
    ASSERT_GE(s.gap, -1000 * eps);
    if (s.gap < Real(1e-9)) break;
    t += safe_time(s, {velocity, 0, spin.norm(), bounding_radius(bullet)}, {});
  }
  EXPECT_LT(steps, 200);
  EXPECT_NEAR(t, (5 - Real(0.001)) / 900, Real(0.02) / 900);  // within the bullet's length of the wall
}

// It is no more careful than it must be: exact for a ball on its way to a plane, infinite for one that
// leaves.
TEST(GeometryAdvance, IsSharpForABallWithoutSpin) {
  const Shape ball = Sphere{Real(0.2)};
  const Plane plane{Vector3(Real(0.6), Real(0.8), 0), Real(-1)};
  const Separation s = separation(ball, {{1, Real(0.7), 2}, Matrix3::Identity()}, plane);
  const Vector3 towards = -3 * plane.normal + Vector3(0, 0, 5);
  EXPECT_NEAR(safe_time(s, {towards, 0, 0, Real(0.2)}, {}), s.gap / 3, 4 * eps);
  EXPECT_EQ(safe_time(s, {-towards, 0, 0, Real(0.2)}, {}), std::numeric_limits<Real>::infinity());
  EXPECT_NEAR(safe_time(s, {-towards, 4, 0, Real(0.2)}, {}), s.gap / 4, 4 * eps);
}

}  // namespace
}  // namespace cylon::engine
