// One method was chosen for a whole scene.  Five boxes 100 m away from a spinning top put the top in fixed
// first-order steps: it was off by 1.8 instead of 6e-12.  A floor 110 m below a double pendulum, which
// nothing can reach, did the same: it lost 7.3 J in 10 s.  Neighbours on a joint collided, so a car was
// refused because its wheels reach into its chassis.
#include "harness/process/client.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::process {
namespace {

constexpr double g = 9.81;

core::Body box(std::string name, const core::Vector3& position, const core::Vector3& half) {
  core::Body body;
  body.name = std::move(name);
  body.mass = 1;
  const core::Vector3 s = half.cwiseAbs2();
  body.inertia = core::Vector3(s[1] + s[2], s[0] + s[2], s[0] + s[1]).asDiagonal();
  body.inertia /= 3;
  body.shape = core::Box{half};
  body.collide = true;
  body.initial.position = position;
  return body;
}

core::Scene with_floor(double offset) {
  core::Scene scene;
  scene.forces = {core::UniformGravity{{0, -g, 0}}};
  scene.planes = {{"floor", core::Vector3::UnitY(), offset}};
  scene.materials = {{{"*", "*"}, 0, 0.5}};
  return scene;
}

RunOutcome played(const core::Scene& scene, double dt, std::int64_t steps, std::int64_t every = 1) {
  RunRequest request;
  request.scene = &scene;
  request.setup.dt = dt;
  request.steps = steps;
  request.every = every;
  return run(parse_engine("in-house", default_engines(binary_dir)), request);
}

// A symmetric top that spins on its tip, tilted.
void add_top(core::Scene& scene) {
  core::Body top;
  top.name = "top";
  top.mass = 1;
  top.inertia = core::Vector3(0.01, 0.005, 0.01).asDiagonal();
  const core::Vector3 tip(0, 100, 0);
  const core::Quaternion turn(Eigen::AngleAxisd(-0.5, core::Vector3::UnitZ()));
  const core::Vector3 w = turn * core::Vector3(0, 60, 0);
  top.initial.position = tip + turn * core::Vector3(0, 0.3, 0);
  top.initial.orientation = turn;
  top.initial.angular_velocity = w;
  top.initial.velocity = w.cross(top.initial.position - tip);
  core::Joint joint;
  joint.body = static_cast<int>(scene.bodies.size());
  joint.point = tip;
  scene.bodies.push_back(top);
  scene.joints.push_back(joint);
}

TEST(PartsOfAScene, BoxesFarAwayLeaveATopAlone) {
  core::Scene alone = with_floor(0), both = with_floor(0);
  add_top(alone), add_top(both);
  for (int i = 0; i < 5; ++i)
    both.bodies.push_back(box("box" + std::to_string(i), {60, 0.5 + i, 0}, {0.5, 0.5, 0.5}));
  const RunOutcome one = played(alone, 1e-3, 1000, 250), two = played(both, 1e-3, 1000, 250);
  ASSERT_TRUE(one.recording && two.recording) << one.reason << two.reason;
  for (std::size_t k = 0; k < one.recording->states.size(); ++k) {
    const core::BodyState &a = one.recording->states[k][0], &b = two.recording->states[k][0];
    EXPECT_EQ(a.position, b.position) << k;
    EXPECT_EQ(a.orientation.coeffs(), b.orientation.coeffs()) << k;
    EXPECT_EQ(a.angular_velocity, b.angular_velocity) << k;
  }
}

// Kinetic and potential energy [J].
double energy(const core::Scene& scene, const core::State& state) {
  double sum = 0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const core::BodyState& s = state[i];
    const core::Matrix3 r = s.orientation.toRotationMatrix();
    const core::Vector3 w = r.transpose() * s.angular_velocity;
    sum += scene.bodies[i].mass * (s.velocity.squaredNorm() / 2 + g * s.position.y()) +
           w.dot(scene.bodies[i].inertia * w) / 2;
  }
  return sum;
}

core::Scene double_pendulum(double floor) {
  core::Scene scene = with_floor(floor);
  scene.bodies = {box("a", {0.5, 0, 0}, {0.4, 0.05, 0.05}), box("b", {1.5, 0, 0}, {0.4, 0.05, 0.05})};
  for (int i = 0; i < 2; ++i) {
    core::Joint joint;
    joint.type = core::JointType::hinge;
    joint.body = i;
    joint.to = i - 1;
    joint.point = {static_cast<double>(i), 0, 0};
    joint.axis = core::Vector3::UnitZ();
    scene.joints.push_back(joint);
  }
  return scene;
}

TEST(PartsOfAScene, DoublePendulumFarAboveAFloorKeepsItsEnergy) {
  const core::Scene scene = double_pendulum(-110);
  const RunOutcome outcome = played(scene, 1e-3, 2000, 100);
  ASSERT_TRUE(outcome.recording) << outcome.reason;
  const double start = energy(scene, core::initial_state(scene));
  for (const core::State& state : outcome.recording->states) EXPECT_NEAR(energy(scene, state), start, 1e-8);
}

// A floor that it does reach stops it: the floor is not forgotten.
TEST(PartsOfAScene, DoublePendulumMeetsAFloorWithinReach) {
  const core::Scene scene = double_pendulum(-1.2);
  const RunOutcome outcome = played(scene, 1e-3, 1500, 1500);
  ASSERT_TRUE(outcome.recording) << outcome.reason;
  EXPECT_LT(energy(scene, outcome.recording->states.back()), energy(scene, core::initial_state(scene)) - 1);
}

// Four balls as wheels, each half inside the chassis, on hinges.
TEST(PartsOfAScene, WheelsMayReachIntoTheirChassis) {
  core::Scene scene = with_floor(0);
  scene.bodies.push_back(box("chassis", {0, 0.3, 0}, {0.8, 0.1, 0.4}));
  for (int i = 0; i < 4; ++i) {
    core::Body wheel = box("wheel" + std::to_string(i), {i % 2 == 0 ? -0.6 : 0.6, 0.2, i < 2 ? -0.45 : 0.45},
                           {0.1, 0.1, 0.1});
    wheel.shape = core::Sphere{0.2};
    wheel.inertia = core::Matrix3::Identity() * 0.016;
    core::Joint joint;
    joint.type = core::JointType::hinge;
    joint.body = static_cast<int>(scene.bodies.size());
    joint.to = 0;
    joint.point = wheel.initial.position;
    joint.axis = core::Vector3::UnitZ();
    scene.bodies.push_back(wheel);
    scene.joints.push_back(joint);
  }
  for (core::Body& body : scene.bodies) body.initial.velocity = {1, 0, 0};
  for (std::size_t i = 1; i < 5; ++i) scene.bodies[i].initial.angular_velocity = {0, 0, -5};
  const RunOutcome outcome = played(scene, 1. / 240, 240, 240);
  ASSERT_TRUE(outcome.recording) << outcome.reason;
  const core::BodyState& chassis = outcome.recording->states.back()[0];
  EXPECT_NEAR(chassis.position.x(), 1, 0.02);  // rolls on
  EXPECT_NEAR(chassis.position.y(), 0.3, 0.01);
}

}  // namespace
}  // namespace cylon::process
