// What rests: a blow goes through it, pair by pair; nothing moves it before it is reached; rounding does not shake it.
#include "engine/event_stepper.h"
#include "engine/water.h"
#include "engine/world.h"
#include "tests/engine/joint_types.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::engine {
namespace {

constexpr Real fall = Real(0.2);
const Real blow = std::sqrt(2 * g * fall), then = blow / g;  // [m/s, s]

Model box_on_floor(Real mass) {
  Model model = pile_model(1, 0);
  add_box(model, mass, {Real(0.1), Real(0.1), Real(0.1)}, {0, Real(0.1), 0});
  add_ball(model, 1, Real(0.1), {0, Real(0.3) + fall, 0});
  return model;
}

Model ball_on_stop() {
  Model model = pile_model(1, 0, false);
  add_ball(model, 1, Real(0.1), Vector3::Zero());
  add_ball(model, 1, Real(0.1), {0, Real(0.2) + fall, 0});
  Joint slider{.type = joint_types::slider, .body = 0};
  slider.axis = slider.to_axis = Vector3::UnitY();
  model.joints.push_back(slider);
  CoordinateLaw law;
  law.at.kind = Coordinate::Kind::displacement;
  law.at.axis = Vector3::UnitY();
  law.lower = 0, law.restitution = 1;
  model.forces.coordinate_laws.push_back(law);
  return model;
}

// Equal masses exchange their velocities twice, and the ball leaves as fast as it came; it had stopped dead.
TEST(BlowOnWhatRests, GoesThroughItAndBack) {
  for (const Model& model : {box_on_floor(1), ball_on_stop()}) {
    const Time end = static_cast<Time>(then) + 0.1;
    EventStepper stepper(model, *find_integrator("dop853"), end / 10, Real(1e-11));
    const auto motions = after(stepper, 10);
    const Real t = Real(0.1), start = model.motions[1].position.y() - fall;
    EXPECT_NEAR(motions[1].momentum.y(), blow - g * t, Real(1e-9));
    EXPECT_NEAR(motions[1].position.y(), start + blow * t - g * t * t / 2, Real(1e-9));
    EXPECT_NEAR(motions[0].momentum.norm(), 0, Real(1e-9));
  }
}

// A box three times as heavy takes half of the blow, is thrown back by the floor and gives it all back.
TEST(BlowOnWhatRests, KeepsTheEnergyOfUnequalMasses) {
  const Model model = box_on_floor(3);
  EventStepper stepper(model, *find_integrator("dop853"), 0.03, Real(1e-11));
  const auto motions = after(stepper, 10);
  EXPECT_NEAR(mechanical_energy(model, motions), mechanical_energy(model, model.motions), 1e-9);
}

Model hung(Real height, Real damping) {
  Model model = pile_model(0, 0, false);
  add_box(model, 2, {Real(0.1), Real(0.1), Real(0.1)}, {0, height, 0});
  Spring spring;
  spring.body = 0, spring.to_anchor = {0, height + Real(0.7), 0};
  spring.rest_length = Real(0.56), spring.damping = damping;
  spring.stiffness = 2 * g / (Real(0.7) - Real(0.56));
  model.forces.springs.push_back(spring);
  return model;
}

Motion after_steps(const Model& model, int steps) {
  Options options;
  options.dt = 1. / 64;
  World world(model, options);
  world.advance(steps);
  return world.motions()[0];
}

// Errors were measured by the rounding of the forces that balance, and no step was small enough.
TEST(AtRest, WhatASpringHoldsAtTheOriginStays) {
  for (const Real height : {Real(0), Real(1)})
    for (const Real damping : {Real(0), Real(0.3), Real(3)}) {
      const Motion end = after_steps(hung(height, damping), 256);
      EXPECT_LT((end.position - Vector3(0, height, 0)).norm(), Real(1e-12)) << height << ' ' << damping;
    }
}

// y = a exp(-c t) (cos w t + c/w sin w t),  c = damping/(2 m),  w^2 = k/m - c^2.  A tolerance of 1e-10 of so small a motion is
// less than the rounding of the spring's length: it was looked for for 20 s.
TEST(AtRest, WhatIsHardlyOffBalanceSwingsBack) {
  const double t = 2, c = 0.3 / 4, k = static_cast<double>(2 * g) / 0.14, w = std::sqrt(k / 2 - c * c);
  for (const double off : {1e-9, 1e-7, 1e-6, 1e-5}) {
    Model model = hung(0, Real(0.3));
    model.motions[0].position.y() = static_cast<Real>(off);
    const double exact = off * std::exp(-c * t) * (std::cos(w * t) + c / w * std::sin(w * t));
    EXPECT_NEAR(static_cast<double>(after_steps(model, 128).position.y()), exact, 1e-14) << off;
  }
}

// The surface 0.06 sin(x - t/2) is below the box, whose bottom is at 0.05, until t = 2 pi.  One step of the integrator had no
// stage in the water, and was 15 625 s long.
TEST(AtRest, UntilAWaveComes) {
  Model model = pile_model(0, 0, false);
  add_box(model, 2, {Real(0.1), Real(0.1), Real(0.1)}, {0, Real(0.15), 0});
  Spring spring;
  spring.to_anchor = {0, Real(2.15), 0}, spring.stiffness = g;
  model.forces.springs.push_back(spring);
  Water water;
  water.wave = Real(0.06), water.speed = Real(0.5), water.buoyancy = 1000, water.shapes = model.shapes;
  model.forces.waters.push_back(water);
  const Motion still = after_steps(model, 256), moved = after_steps(model, 640);
  EXPECT_NEAR(still.position.y(), 0.15, 1e-12);
  EXPECT_NEAR(still.momentum.y(), 0, 1e-12);
  EXPECT_GT(std::abs(moved.position.y() - Real(0.15)), Real(1e-3));
  EXPECT_LT(moved.position.norm(), 1);
}

}  // namespace
}  // namespace cylon::engine
