// What engines tell of their joints, against statics and Newton's second law by hand.
#include "tests/conformance/adapters_fixture.h"

#include <cmath>
#include <vector>

namespace cylon::conformance {
namespace {

class Reactions : public EveryEngine {
 protected:
  void SetUp() override {
    EveryEngine::SetUp();
    if (!IsSkipped() && !subject().tells) GTEST_SKIP() << "the adapter tells no forces";
  }
};
INSTANTIATE_TEST_SUITE_P(Adapters, Reactions, testing::ValuesIn(subjects), test_name);

constexpr double dt = 1. / 512;

core::Body body(const char* name, const Vector3& position, double mass) {
  core::Body body;
  body.name = name, body.mass = mass, body.inertia = Vector3(0.02, 0.03, 0.04).asDiagonal();
  body.initial.position = position;
  return body;
}

core::Recording play_and_tell(const Subject& subject, const core::Scene& scene, std::int64_t steps) {
  process::RunRequest request;
  request.scene = &scene, request.setup.dt = dt;
  request.steps = steps, request.every = 1, request.contacts = true;
  process::RunOutcome outcome = process::run(subject.choice(), request, limits);
  if (!outcome.recording) throw std::runtime_error(outcome.reason);
  return *outcome.recording;
}

// A beam welded at one end, with a second one welded to its tip: each weld bears what hangs beyond it, and its
// moment.  `turned`: the joints name their bodies the other way round, and the wall is a locked body.
core::Scene beams(bool turned) {
  core::Scene scene;
  scene.forces = {core::UniformGravity{{0, -9.81, 0}}};
  scene.bodies = {body("beam", {0.5, 0, 0}, 2), body("tip", {1.25, 0, 0.25}, 0.5)};
  scene.joints = {{core::JointType::fixed, 0, core::world, {0, 0, 0}},
                  {core::JointType::fixed, 1, 0, {1, 0, 0}}};
  if (!turned) return scene;
  scene.bodies.push_back(body("wall", {-1, 0, 0}, 1));
  scene.bodies.back().locked = true;
  scene.joints = {{core::JointType::fixed, 2, 0, {0, 0, 0}}, {core::JointType::fixed, 0, 1, {1, 0, 0}}};
  return scene;
}

// Force and torque of the reaction about a point of the world.
Vector3 moment_about(const core::Reaction& r, const Vector3& point) {
  return r.moment + (r.point - point).cross(r.impulse);
}

TEST_P(Reactions, HoldWeldedBeams) {
  for (const bool turned : {false, true}) {
    const core::Recording run = play_and_tell(subject(), beams(turned), 64);
    if (subject().reduced) {
      EXPECT_FALSE(run.reactions) << "Bullet's multibodies tell no forces of joints";
      continue;
    }
    ASSERT_TRUE(run.reactions);
    ASSERT_EQ(run.reactions->size(), 2U);
    const double g = 9.81 * dt, sign = turned ? -1 : 1;
    const Vector3 force[] = {{0, 2.5 * g, 0}, {0, 0.5 * g, 0}};
    const Vector3 moment[] = {{-0.25 * 0.5 * g, 0, (2 * 0.5 + 0.5 * 1.25) * g},
                              {-0.25 * 0.5 * g, 0, 0.25 * 0.5 * g}};
    const double near = subject().iterative ? 0.02 : subject().single ? 1e-3 : 1e-6;
    for (const core::Reaction& r : *run.reactions) {
      const Vector3 point = r.joint == 0 ? Vector3(0, 0, 0) : Vector3(1, 0, 0);
      expect_within(fmt::format("{}: force of joint {}", subject().id, r.joint),
                    (sign * r.impulse - force[r.joint]).norm(), near * force[0].norm());
      expect_within(fmt::format("{}: moment of joint {}", subject().id, r.joint),
                    (sign * moment_about(r, point) - moment[r.joint]).norm(), near * moment[0].norm());
    }
  }
}

// A ball at rest on two locked boxes that lean towards it, named before it or after.  ODE's adapter read the force
// of a contact whose first body is locked where ODE does not write it, and told none.
TEST_P(Reactions, OfLockedBodiesBearWhatLiesOnThem) {
  if (!subject().touches) GTEST_SKIP() << "it has no contacts that a scene could state";
  const double lean = 0.5, radius = 0.3, thick = 0.2;
  for (const bool first : {false, true}) {
    core::Scene scene;
    scene.forces = {core::UniformGravity{{0, -9.81, 0}}};
    scene.materials = {{{"*", "*"}, 0, 0}};
    core::Body ball = body("ball", {0, 0, 0}, 1.5);
    ball.inertia = Vector3::Constant(0.4 * 1.5 * radius * radius).asDiagonal();
    ball.shape = core::Sphere{radius}, ball.collide = true;
    std::vector<core::Body> walls;
    for (const double side : {-1.0, 1.0}) {
      const Vector3 away(side * std::sin(lean), -std::cos(lean), 0);
      core::Body wall = body(side < 0 ? "left" : "right", (radius + thick) * away, 1);
      wall.initial.orientation = Quaternion(Eigen::AngleAxisd(side * lean, Vector3::UnitZ()));
      wall.shape = core::Box{{0.2, thick, 0.2}}, wall.collide = wall.locked = true;
      walls.push_back(wall);
    }
    scene.bodies = walls;
    scene.bodies.insert(first ? scene.bodies.end() : scene.bodies.begin(), ball);
    const int of_ball = first ? 2 : 0;
    const core::Recording run = play_and_tell(subject(), scene, 64);
    ASSERT_TRUE(run.contacts);
    Vector3 given = Vector3::Zero();
    for (const core::Contact& c : *run.contacts) {
      ASSERT_TRUE(c.impulse);
      const Vector3 impulse = *c.impulse * c.normal + c.friction.value_or(Vector3(Vector3::Zero()));
      given += c.pair.body == of_ball ? impulse : Vector3(-impulse);
    }
    const double weight = 1.5 * 9.81 * dt;
    expect_within(fmt::format("{}: ball named {}", subject().id, first ? "last" : "first"),
                  (given - Vector3(0, weight, 0)).norm(),
                  (subject().iterative || subject().single || subject().reduced ? 0.02 : 1e-6) * weight);
  }
}

// A body that swings on a ball joint from another that swings from the world: m dv = m g dt + J1 - J2.
TEST_P(Reactions, AreWhatMovesLinks) {
  core::Scene scene;
  scene.forces = {core::UniformGravity{{0, -9.81, 0}}};
  scene.bodies = {body("upper", {0.4, -0.1, 0.2}, 1.5), body("lower", {0.9, -0.3, 0.5}, 0.7)};
  scene.joints = {{core::JointType::ball, 0, core::world, {0, 0, 0}},
                  {core::JointType::ball, 0, 1, {0.7, -0.2, 0.3}}};
  const core::Recording run = play_and_tell(subject(), scene, 100);
  if (subject().reduced) {
    EXPECT_FALSE(run.reactions);
    return;
  }
  ASSERT_TRUE(run.reactions);
  ASSERT_EQ(run.reactions->size(), 2U);
  const core::State &now = run.states.back(), &before = run.states[run.states.size() - 2];
  Vector3 given[] = {Vector3::Zero(), Vector3::Zero()};
  for (const core::Reaction& r : *run.reactions) {
    given[0] += r.impulse;
    if (r.joint == 1) given[1] -= r.impulse;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const double mass = scene.bodies[i].mass;
    const Vector3 change = mass * (now[i].velocity - before[i].velocity + dt * Vector3(0, 9.81, 0));
    // Mean of both ends, dt^2 F''/12 of a force that changes at some 10/s, where forces are of an instant;
    // else the rounding of m v.
    const double near = subject().order > 1 ? 100 * dt * dt / 12 * mass * 9.81 * dt : 0;
    expect_within(fmt::format("{}: body {}", subject().id, i), (change - given[i]).norm(),
                  near + 2000 * subject().unit() * mass * 3);
    EXPECT_GT(given[i].norm(), 0.1 * mass * 9.81 * dt);
  }
}

}  // namespace
}  // namespace cylon::conformance
