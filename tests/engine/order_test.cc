// The observed order of each scheme: halve the step, fit the slope.
#include "tests/engine/fixtures.h"

#include <functional>

namespace cylon::engine {
namespace {

constexpr Real reach =
    0.1;  // how far the slope may be from the order; the next term is below 2^-5 of the first here

// Steps per run, coarse; small enough for the leading term, large enough to stay above rounding.
int coarse_steps(int order) { return order == 4 ? 128 : order == 2 ? 1024 : 16384; }

using Error = std::function<Real(const World&, const World&)>;

Real observed_order(const Start& start, const Integrator& scheme, Real duration, const Error& error) {
  const int n = coarse_steps(scheme.order);
  const World exact = run(start, *find_integrator("rk4"), duration, 4096);
  const World coarse = run(start, scheme, duration, n), fine = run(start, scheme, duration, 2 * n);
  EXPECT_GT(error(fine, exact), 1e-12) << "rounding, not truncation";
  return std::log2(error(coarse, exact) / error(fine, exact));
}

Real tilt(const World& a, const World& b) {
  const Vector3 x = a.motion()[0].orientation * Vector3::UnitY(),
                y = b.motion()[0].orientation * Vector3::UnitY();
  return std::atan2(x.cross(y).norm(), x.dot(y));
}

class Order : public EveryIntegrator {};

TEST_P(Order, OfBodiesOnOffCentreSprings) {
  EXPECT_NEAR(observed_order(coupled_bodies(), GetParam(), 1.0, distance), GetParam().order, reach);
}

TEST_P(Order, OfBodiesUnderEveryForce) {
  EXPECT_NEAR(observed_order(forced_bodies(), GetParam(), 1.0, distance), GetParam().order, reach);
}

TEST_P(Order, OfAFreeAsymmetricTop) {
  EXPECT_NEAR(observed_order(free_top(), GetParam(), 1.0, distance), GetParam().order, reach);
}

TEST_P(Order, OfAHeavyTopsAxis) {
  EXPECT_NEAR(observed_order(heavy_top(), GetParam(), 0.5, tilt), GetParam().order, reach);
}

// With an impact inside a step the order holds only because the impact is at its own time.
TEST_P(Order, OfASpringThatStrikesAWall) {
  Start start;
  add_body(start, make_body(1.2, Matrix3::Identity()), {0.7, 0.2, 0.3}, {0.1, 0.2, 0.3}, {-0.3, 0.4, 0.1},
           {0, 0, 0});
  start.model.forces.springs.push_back({0, {0, 0, 0}, fixed_world, {0.1, 0.3, -0.2}, 17.0, 0.35, 0.2});
  Contact wall;
  wall.normal = Vector3(1, 0.1, -0.2).normalized();
  wall.radius = 0.1;
  wall.offset = 0.05;
  wall.restitution = 0.7;
  start.model.contacts.push_back(wall);

  int impacts = 0;
  World running(start.model, start.motion, GetParam(), 1e-3);
  for (int i = 0; i < 1000; ++i) running.step(), impacts += static_cast<int>(running.impacts().size());
  ASSERT_GE(impacts, 1);
  EXPECT_NEAR(observed_order(start, GetParam(), 1.0, distance), GetParam().order, reach);
}

CYLON_EVERY_INTEGRATOR(Order);

// The measure itself: a scheme that claims more than it does is found out.
TEST(OrderMeasure, FindsAFalseClaim) {
  Integrator boaster = *find_integrator("explicit-euler");
  boaster.order = 2;
  EXPECT_GT(std::abs(observed_order(coupled_bodies(), boaster, 1.0, distance) - boaster.order), 5 * reach);
}

}  // namespace
}  // namespace cylon::engine
