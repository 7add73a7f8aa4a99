// A stop, or a contact, and dry friction on one coordinate.  The row of the one was that of the other, their forces were
// shared evenly, and friction came to its bound though nothing moved: it ended and began to hold thousands of times
// in a step, which took seconds and ended in remarks of events that are not followed.
#include "tests/engine/rail_and_wheel.h"

#include <limits>
#include <numbers>

namespace cylon::engine {
namespace {

constexpr Real g = 9.81, friction = 0.37;

// Pressed on a stop where it stands by m g along the rail, and across it; a drive of `push` along the rail.
Model on_stop(Real push, Time frequency) {
  Model model = body_on_rail(0);
  model.forces.gravity = -g * rail_axis + 3 * rail_axis.unitOrthogonal();
  CoordinateLaw law;
  law.at = along_rail();
  law.lower = 0, law.friction = friction;
  model.forces.coordinate_laws.push_back(law);
  model.forces.drives.push_back({0, push * rail_axis, static_cast<Real>(frequency)});
  return model;
}

Options form(bool constraints, const char* integrator = "auto") {
  Options options = with(integrator, 0.01);
  options.constraints = constraints;
  return options;
}

constexpr Real rounding = 64 * epsilon;

// 1.1 N against 12.8 N: nothing happens.
TEST(StopWithDryFriction, KeepsWhatIsPressedOnIt) {
  const Model model = on_stop(1.1, 2.3);
  for (const bool constraints : {false, true})
    for (const char* integrator : {"auto", "rk8"}) {
      World world(model, form(constraints, integrator));
      for (int i = 0; i < 200; ++i) world.step();
      EXPECT_LE(distance(world.motions(), model.motions), rounding) << integrator;
      EXPECT_TRUE(world.remarks().empty()) << world.remarks().front();
      EXPECT_LT(world.operations(), 2'000'000) << "3e5";
    }
}

// It leaves the stop where the drive carries weight and friction, A cos w t = m g + b on the way up, not where it
// carries the weight alone, and rises
//   m x'' = A cos w t - m g - b.
TEST(StopWithDryFriction, LetsGoWhereWeightAndFrictionAreCarried) {
  const Real push = 1.5 * rail_mass * g, w = 2.3;
  const Model model = on_stop(-push, w);  // it begins downwards
  const Real leaves = (std::numbers::pi_v<Real> - std::acos((rail_mass * g + friction) / push)) / w;
  const auto exact = [&](Real t) -> Real {
    if (t <= leaves) return 0;
    const Real s = t - leaves, a = push / rail_mass, c = g + friction / rail_mass;
    return a / (w * w) * (std::cos(w * t) - std::cos(w * leaves)) + a / w * std::sin(w * leaves) * s -
           c * s * s / 2;
  };
  for (const bool constraints : {false, true}) {
    const Outcome end = run(model, form(constraints), 140, [&](const World& world) {
      const Real t = static_cast<Real>(world.time());
      ASSERT_NEAR(along_rail(world.motions()), exact(t), 1e-9) << t;
    });
    EXPECT_GT(exact(1.4), 0.01);
    EXPECT_TRUE(end.remarks.empty()) << end.remarks.front();
  }
}

// The same of a floor that stops the body, on a rail that is inclined to it, with friction of its own.
TEST(StopWithDryFriction, KeepsWhatAFloorStops) {
  Model model = on_stop(1.1, 2.3);
  CoordinateLaw& law = model.forces.coordinate_laws[0];
  law.lower = -std::numeric_limits<Real>::infinity();
  const Vector3 up = (4 * rail_axis + 3 * rail_axis.unitOrthogonal()) / 5;
  model.shapes[0] = Sphere{Real(0.1)};
  model.planes.push_back({up, up.dot(rail_start) - Real(0.1)});
  make_touchable(model, Real(0.3), Real(0.4));
  for (const bool constraints : {false, true}) {
    World world(model, form(constraints));
    for (int i = 0; i < 200; ++i) world.step();
    EXPECT_LE(distance(world.motions(), model.motions), rounding);
    EXPECT_TRUE(world.remarks().empty()) << world.remarks().front();
    EXPECT_LT(world.operations(), 2'000'000);
  }
}

}  // namespace
}  // namespace cylon::engine
