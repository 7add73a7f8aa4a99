// A gravity that a body states reaches every engine, in place of the scene's.
#include "tests/conformance/adapters_fixture.h"

namespace cylon::conformance {
namespace {

class OwnGravity : public EveryEngine {};
INSTANTIATE_TEST_SUITE_P(Adapters, OwnGravity, testing::ValuesIn(subjects), test_name);

const Vector3 of_all(0.4, -9.1, 0.3), own(1.3, 2.4, -0.8);
constexpr double dt = 1. / 512;
constexpr int steps = 200;

// v = v0 + g t whatever the scheme, to the roundings of as many increments.
TEST_P(OwnGravity, StandsInPlaceOfTheScenes) {
  core::Scene scene = three_bodies(51);
  for (core::Body& body : scene.bodies) body.initial.angular_velocity = Vector3::Zero();
  scene.forces.emplace_back(core::UniformGravity{of_all});
  scene.bodies[1].gravity = own, scene.bodies[2].gravity = Vector3::Zero();
  const core::State end = last(subject().choice(), scene, dt, steps);
  const Vector3 falls[] = {of_all, own, Vector3::Zero()};
  for (std::size_t i = 0; i < 3; ++i)
    expect_within(fmt::format("velocity of body {}, {}", i, subject().id),
                  (end[i].velocity - scene.bodies[i].initial.velocity - dt * steps * falls[i]).norm(),
                  16 * steps * subject().unit());
  EXPECT_EQ(end[2].velocity, last(subject().choice(), scene, dt, 1)[2].velocity)
      << "a weightless body flies on";
}

// Also where no other force acts, where other forces do, and of a body whose mass changes.
TEST_P(OwnGravity, ActsBesideOtherForces) {
  core::Scene scene = three_bodies(52);
  scene.forces.emplace_back(core::Drag{0, 0.3, 0, 0});
  scene.forces.emplace_back(core::Spring{1, {0.1, 0, 0.2}, core::world, {0.5, 1, 0.2}, 6, 0.4, 0.1});
  scene.forces.emplace_back(core::Thrust{2, {0, 0, 0}, -0.1, Vector3(0.5, -2, 1), {}});
  core::Scene stated = scene;
  scene.forces.emplace_back(core::UniformGravity{own});
  for (core::Body& body : stated.bodies) body.gravity = own;
  core::Scene other = stated;
  other.forces.emplace_back(core::UniformGravity{of_all});
  const core::State expected = last(subject().choice(), scene, dt, steps);
  for (const core::Scene& one : {stated, other})
    expect_within(fmt::format("beside other forces, {}", subject().id),
                  difference(last(subject().choice(), one, dt, steps), expected), 1e4 * subject().unit());
}

// Of links: a chain whose bodies state the gravity swings as one in that gravity.
TEST_P(OwnGravity, ActsOnMechanisms) {
  core::Scene scene = three_bodies(53);
  for (core::Body& body : scene.bodies)
    body.initial.velocity = body.initial.angular_velocity = Vector3::Zero();
  scene.bodies[1].initial.position = scene.bodies[0].initial.position + Vector3(0.4, -0.3, 0.2);
  scene.bodies[2].initial.position = scene.bodies[1].initial.position + Vector3(0.3, -0.5, -0.1);
  for (int i = 0; i < 3; ++i)
    scene.joints.push_back(
        {.body = i,
         .to = i - 1 < 0 ? core::world : i - 1,
         .point = scene.bodies[static_cast<std::size_t>(i)].initial.position + Vector3(-0.15, 0.2, 0.1)});
  core::Scene stated = scene;
  scene.forces.emplace_back(core::UniformGravity{own});
  stated.forces.emplace_back(core::UniformGravity{of_all});
  for (core::Body& body : stated.bodies) body.gravity = own;
  const core::State expected = last(subject().choice(), scene, dt, steps),
                    end = last(subject().choice(), stated, dt, steps);
  expect_within(fmt::format("a chain, {}", subject().id), difference(end, expected),
                (subject().iterative ? 1e6 : 1e5) * subject().unit());
  stated.bodies[2].gravity.reset();  // the control
  EXPECT_GT(difference(last(subject().choice(), stated, dt, steps), expected), 0.01);
}

}  // namespace
}  // namespace cylon::conformance
