// Pendulums that fall onto a stop of their joint and bounce there until they rest.
#include "tests/engine/mixed_scenes_check.h"

namespace cylon::engine {
namespace {

Model pendulum_at_a_stop(std::uint32_t number) {
  Dice dice(number);
  Model model;
  model.forces.gravity = {0, Real(-9.81), 0};
  const Vector3 inertia = Vector3(Real(0.1), Real(0.1), Real(0.1)) + dice.vector(Real(0.03));
  const Body body = make_body(dice.between(Real(0.3), 3), inertia.asDiagonal());
  const Vector3 place = dice.vector(1);
  const Quaternion turn = exponential(dice.vector(2));
  model.bodies.push_back(body);
  model.motions.push_back(make_motion(body, place, turn, Vector3::Zero(), Vector3::Zero()));
  const Vector3 axis = (dice.vector(1) + Vector3(0, 0, 2)).normalized();
  const Vector3 point = place + Vector3(dice.between(Real(-0.6), Real(-0.3)), 0, 0) + dice.vector(Real(0.1));
  Joint joint{.type = joint_types::hinge, .body = 0, .to = fixed_world};
  joint.anchor = turn.conjugate() * (point - place);
  joint.to_anchor = point;
  joint.axis = turn.conjugate() * axis;
  joint.to_axis = axis;
  joint.relative = turn;
  CoordinateLaw law;
  law.at.kind = Coordinate::Kind::angle;
  law.at.body = 0, law.at.anchor = joint.anchor, law.at.to = fixed_world, law.at.to_anchor = point;
  law.at.axis = axis, law.at.zero = axis.unitOrthogonal();
  law.at.mark = joint.relative.conjugate() * law.at.zero;
  law.lower = dice.between(Real(-0.4), Real(-0.1)), law.upper = 2;
  law.restitution = dice.between(Real(0.3), Real(0.8));
  model.joints.push_back(joint);
  model.forces.coordinate_laws.push_back(law);
  return model;
}

// What moves a coordinate is what joints make of the weight: rounding was taken relative to the torque on the body, which is
// none, so that speeds of 1e-23 rad/s were bounces, 4000 of them in a step.
TEST(PendulumAtAStop, RestsAfterItsBounces) {
  for (std::uint32_t number = 0; number < 40; ++number) {
    const Model model = pendulum_at_a_stop(number);
    Options options = with("auto", 0.01);
    options.constraints = true;
    World world(model, options);
    for (int step = 0; step < 300; ++step) world.step();
    EXPECT_LT(world.operations(), 2'500'000) << number;
    EXPECT_LT(world.motions()[0].momentum.norm(), 1e-12) << number;
    EXPECT_TRUE(world.remarks().empty()) << number << world.remarks()[0];
  }
}

}  // namespace
}  // namespace cylon::engine
