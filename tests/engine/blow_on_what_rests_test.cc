// A blow on what rests, pair by pair: what passes it on ends at rest itself, and that is no bounce too low to follow.
#include "engine/event_stepper.h"
#include "tests/engine/joint_types.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::engine {
namespace {

constexpr Real height = Real(0.2);
const Real blow = std::sqrt(2 * g * height), then = blow / g;  // [m/s, s]

Model box_on_floor(Real mass) {
  Model model = pile_model(1, 0);
  add_box(model, mass, {Real(0.1), Real(0.1), Real(0.1)}, {0, Real(0.1), 0});
  add_ball(model, 1, Real(0.1), {0, Real(0.3) + height, 0});
  return model;
}

Model ball_on_stop() {
  Model model = pile_model(1, 0, false);
  add_ball(model, 1, Real(0.1), Vector3::Zero());
  add_ball(model, 1, Real(0.1), {0, Real(0.2) + height, 0});
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
    const Real t = Real(0.1), start = model.motions[1].position.y() - height;
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

}  // namespace
}  // namespace cylon::engine
