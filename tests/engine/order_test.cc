// The observed order of each integrator on the engine's own systems: halve the step, fit the slope.
#include "tests/engine/fixtures.h"

#include <functional>

namespace cylon::engine {
namespace {

// How far the slope may be from the order.  Up to order 4 the next term of the error is small where it is
// measured; the steps of the others cannot be made as small before rounding takes over, and from the large
// steps that remain they may only seem better than they are.
// Within a tenth they are seen in tests/engine/long, with more digits, and in tests/conformance/accuracy, by
// a fit.
void expect_order(Real slope, const Integrator& integrator, int order) {
  if (integrator.order <= 4) {
    EXPECT_NEAR(slope, order, 0.1);
  } else {
    EXPECT_GT(slope, order - 0.5);
  }
}

using Error = std::function<Real(const std::vector<Motion>&, const std::vector<Motion>&)>;

// Halves the step until the error nears rounding (1e-13, grown by the motion).  The slope of the last two,
// or, of high orders, over all steps that are neither too coarse nor too fine.
Real observed_order(const Model& model, const Integrator& integrator, Time duration, const Error& error) {
  const bool high = integrator.order >= 6;
  const int most = high ? 2048 : 16384;
  const Real least = high ? 2e-11 : 2e-12;
  const auto exact = run(model, "rk8", duration, 4096).motions;
  const auto error_of = [&](int n) { return error(run(model, integrator.name, duration, n).motions, exact); };
  std::vector<Real> errors;
  for (int n = 8; n <= most; n *= 2) {
    const Real e = error_of(n);
    if (e < least) break;
    errors.push_back(e);
  }
  const std::size_t n = errors.size();
  return n < 2 ? 0 : std::log2(errors[n - 2] / errors[n - 1]);
}

// Of a run: long for high orders, whose error would else be rounding at all but the largest steps.
Time span(const Integrator& integrator) { return integrator.order >= 6 ? 4.0 : 1.0; }

Real tilt(const std::vector<Motion>& a, const std::vector<Motion>& b) {
  return angle_between(a[0].orientation * Vector3::UnitY(), b[0].orientation * Vector3::UnitY());
}

class Order : public EveryIntegrator {};

TEST_P(Order, OfBodiesOnOffCentreSprings) {
  expect_order(observed_order(coupled_bodies(), GetParam(), span(GetParam()), distance), GetParam(),
               GetParam().order);
}

TEST_P(Order, OfBodiesUnderEveryForce) {
  expect_order(observed_order(forced_bodies(), GetParam(), span(GetParam()), distance), GetParam(),
               GetParam().drag_order);
}

// A splitting moves a free top by its exact flow; a Runge-Kutta integrator integrates its quaternion.
TEST_P(Order, OfAFreeAsymmetricTop) {
  const Model model = free_top();
  if (GetParam().kind == Kind::splitting) {
    const Real few =
        distance(run(model, GetParam().name, 1.0, 16).motions, run(model, GetParam().name, 1.0, 512).motions);
    EXPECT_LT(few, 512 * 1e-15);  // rounding of a few ulp a step
    return;
  }
  expect_order(observed_order(model, GetParam(), span(GetParam()), distance), GetParam(), GetParam().order);
}

TEST_P(Order, OfAHeavyTopsAxis) {
  expect_order(observed_order(heavy_top(), GetParam(), span(GetParam()) / 2, tilt), GetParam(),
               GetParam().order);
}

// Points only: a spring chain in space with drive and attraction.
TEST_P(Order, OfPointsOnSprings) {
  Model model;
  add_body(model, make_body(1.2, Matrix3::Zero()), {0.7, 0.2, 0.3}, {0, 0, 0}, {-0.3, 0.4, 0.1}, {0, 0, 0});
  add_body(model, make_body(0.9, Matrix3::Zero()), {-0.5, 0.9, 0.1}, {0, 0, 0}, {0.3, 0.6, -0.8}, {0, 0, 0});
  model.forces.gravity = {0.1, -9.81, 0.2};
  model.forces.springs.push_back({0, {0, 0, 0}, fixed_world, {0.1, 0.3, -0.2}, 17.0, 0.35, 0});
  model.forces.springs.push_back({1, {0, 0, 0}, 0, {0, 0, 0}, 11.0, 0.6, 0});
  model.forces.drives.push_back({1, {0.9, 0.4, -1.1}, 2.3});
  model.forces.attractions.push_back({0, 1, 0.7});
  EXPECT_EQ(make_plan(model, with(GetParam().name, 0.01)).path, Path::points);
  expect_order(observed_order(model, GetParam(), span(GetParam()), distance), GetParam(), GetParam().order);
}

CYLON_EVERY_SCHEME(Order);

// The measure itself: an integrator that claims more than it does is found out.
TEST(OrderMeasure, DetectsFalseClaim) {
  Integrator boaster = *find_integrator("explicit-euler");
  boaster.order = 2;
  EXPECT_GT(std::abs(observed_order(coupled_bodies(), boaster, 1.0, distance) - boaster.order), 0.5);
}

}  // namespace
}  // namespace cylon::engine
