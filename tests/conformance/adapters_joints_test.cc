// Joints at general points: the gap closes with the step, or is none; what is held by a locked body is held
// as by the world.  The state starts consistent, so every gap is the engine's own.
#include "harness/core/observable.h"
#include "reference/certified/truth.h"
#include "tests/conformance/adapters_fixture.h"

#include <cmath>

namespace cylon::conformance {
namespace {

class Joints : public EveryEngine {};
INSTANTIATE_TEST_SUITE_P(Adapters, Joints, testing::ValuesIn(subjects), test_name);
INSTANTIATE_TEST_SUITE_P(Dart, Joints, testing::Values(dart), test_name);

constexpr double duration = 0.4;

// Body "a" on a ball joint to `to`, body "b" on a ball joint to "a", all turning as one at the start.
core::Scene pendulum(unsigned seed, int links) {
  exact::RandomScenes random(seed);
  core::Scene scene;
  scene.forces = {core::UniformGravity{random.vector(10)}};
  const Vector3 pivot = random.vector(0.5), w = random.vector(3);
  Vector3 point = pivot;
  for (int i = 0; i < links; ++i) {
    core::Body body =
        random.body({random.between(0.03, 0.05), random.between(0.05, 0.07), random.between(0.07, 0.08)});
    body.name = i == 0 ? "a" : "b";
    body.initial.position = point + random.vector(0.4);
    body.initial.velocity = w.cross(body.initial.position - pivot);
    body.initial.angular_velocity = w;
    scene.bodies.push_back(body);
    core::Joint joint;
    joint.body = i;
    joint.to = i - 1;  // the world for the first
    joint.point = point;
    scene.joints.push_back(joint);
    point = body.initial.position + random.vector(0.4);
  }
  return scene;
}

// The largest distance between the two sides of any joint [m].
double gap(const core::Scene& scene, const core::Recording& recording) {
  core::Observable joint_gap;
  joint_gap.quantity = core::Quantity::joint_gap;
  core::Values values;
  double worst = 0;
  for (const core::State& state : recording.states) {
    core::evaluate(joint_gap, scene, state, values);
    worst = std::max(worst, core::magnitude(joint_gap, values));
  }
  return worst;
}

// Feedback of a share erp = 0.2 holds a point of centripetal acceleration a < 25 m/s^2 within a dt^2/(2 erp)
// + O(dt^3): 2.5e-4 m at 2 ms, twice that for two links, and second order in the step; projection and reduced
// coordinates leave rounding.
void expect_closed(const Subject& subject, const core::Scene& scene, const std::string& what) {
  const auto gap_at = [&](std::int64_t steps) {
    return gap(scene, play(subject.choice(), scene, duration / static_cast<double>(steps), steps));
  };
  const bool exact = subject.reduced || subject.order > 1;
  const double coarse = gap_at(200), fine = gap_at(800);
  const std::string name = fmt::format("gap of {}, {}", what, subject.id);
  expect_within(name, coarse, exact ? subject.joint_units * subject.unit() : 5e-4);
  expect_within(name + ", four times finer", fine,
                exact
                    ? subject.joint_units * subject.unit()
                    : coarse / 12 + 64 * subject.unit() + 2 * subject.least_turn);  // arms of 1 m, two sweeps
}

TEST_P(Joints, BallJointToWorldCloses) {
  for (const unsigned seed : {61u, 62u}) expect_closed(subject(), pendulum(seed, 1), "one link");
}

TEST_P(Joints, ABallJointCloses) {
  for (const unsigned seed : {63u, 64u}) expect_closed(subject(), pendulum(seed, 2), "two links");
}

// The same motion in the limit: every engine goes to the certified solution, which knows no engine.
TEST_P(Joints, SwingIsTheCertifiedOne) {
  const core::Scene scene = pendulum(65, 2);
  static const core::Truth truth = certified::solution(scene, duration).truth;
  const core::State reference = truth.state(duration);
  const auto error = [&](std::int64_t steps) {
    return difference(last(subject().choice(), scene, duration / static_cast<double>(steps), steps),
                      reference);
  };
  const double coarse = error(100), fine = error(1000);
  expect_within(fmt::format("swing, {}", subject().id), fine, coarse / 5 + 4000 * subject().unit());
}

// A joint to a locked body is a joint to the world in the same place; 400 steps of a double pendulum gather 5
// units each.
TEST_P(Joints, ALockedBodyHolds) {
  const core::Scene hung = pendulum(66, 2);
  core::Scene held = hung;
  core::Body wall = exact::RandomScenes(67).body({0.3, 0.4, 0.5});
  wall.name = "wall", wall.locked = true;
  wall.initial.velocity = wall.initial.angular_velocity = Vector3::Zero();
  held.bodies.push_back(wall);
  held.joints[0].to = 2;
  core::State state = last(subject().choice(), held, 1e-3, 400);
  EXPECT_EQ((state[2].position - play(subject().choice(), held, 1e-3, 0).states[0][2].position).norm(), 0);
  state.pop_back();
  expect_within(fmt::format("held by a locked body, {}", subject().id),
                difference(state, last(subject().choice(), hung, 1e-3, 400)),
                1000 * subject().drift * subject().unit());
}

// Balls that reach into each other's: with a joint between them that is no contact.
TEST_P(Joints, NeighboursDoNotTouch) {
  if (!subject().touches) GTEST_SKIP() << "it has no contacts that a scene could state";
  core::Scene scene = pendulum(31, 2);
  scene.materials = {{{"*", "*"}, pair_restitution(), 0.3}};
  core::Scene solid = scene;
  for (core::Body& body : solid.bodies) body.shape = core::Sphere{0.4}, body.collide = true;
  const core::State bare = play(subject().choice(), scene, 0.002, 100).states.back();
  const core::State end = play(subject().choice(), solid, 0.002, 100).states.back();
  for (std::size_t i = 0; i < end.size(); ++i) {
    EXPECT_EQ(end[i].position, bare[i].position) << i;
    EXPECT_EQ(end[i].velocity, bare[i].velocity) << i;
  }
}

// Without the joint between them the same balls push each other apart.
TEST_P(Joints, OthersDoTouch) {
  if (!subject().touches) GTEST_SKIP() << "it has no contacts that a scene could state";
  core::Scene scene = pendulum(31, 2);
  scene.materials = {{{"*", "*"}, pair_restitution(), 0.3}};
  scene.joints.pop_back();
  scene.bodies[1].initial.position = scene.bodies[0].initial.position + Vector3(0.9, 0, 0);
  scene.bodies[1].initial.velocity = scene.bodies[0].initial.velocity + Vector3(-6, 0, 0);
  core::Scene solid = scene;
  for (core::Body& body : solid.bodies) body.shape = core::Sphere{0.4}, body.collide = true;
  const core::State bare = play(subject().choice(), scene, 0.002, 100).states.back();
  const core::State end = play(subject().choice(), solid, 0.002, 100).states.back();
  EXPECT_GT((end[1].position - bare[1].position).norm(), 1e-4);
}

// A name is for claims: the workers in JavaScript did not know the key, and ended each scene that has one as a failure.
TEST_P(Joints, AreTheSameByAnyName) {
  core::Scene scene = pendulum(61, 2);
  const core::State unnamed = last(subject().choice(), scene, 1. / 512, 50);
  scene.joints[0].name = "elbow", scene.joints[1].name = "wrist";
  EXPECT_EQ(difference(last(subject().choice(), scene, 1. / 512, 50), unnamed), 0);
}

}  // namespace
}  // namespace cylon::conformance
