// `cylon hunt` found it (seed 4242, scene 335): a spring along the angle of a hinge turns one body, and the body that
// carries the hinge is held.  What the joint that holds it leaves of the torque is rounding; the error-controlled
// integrator measured the held body's error by it, found no step small enough, and every state was NaN.
#include "harness/process/client.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::process {
namespace {

struct Row {
  double inertia;       // of the held body [kg m^2]
  core::Vector3 point;  // of both joints [m]
};

core::Body ball(const char* name, const Row& row, double inertia) {
  core::Body body;
  body.name = name, body.inertia = inertia * core::Matrix3::Identity();
  body.initial.position = row.point;
  return body;
}

// I d2a/dt2 = -k (a - a0) from rest: a = a0 (1 - cos(sqrt(k/I) t)).
TEST(SpringOnAHeldBody, SwingsAboutItsTarget) {
  constexpr double inertia = 0.064, stiffness = 121.173, target = 0.087, duration = 0.1;
  const Row rows[] = {{0.036, {0, 0, 0}}, {0.064, {0, 0, 0}}, {1.7, {0, 0, 0}}, {0.036, {0.3, -0.2, 0.5}}};
  for (const Row& row : rows) {
    core::Scene scene;
    scene.bodies = {ball("held", row, row.inertia), ball("swings", row, inertia)};
    core::Joint fixed{core::JointType::fixed, 0, core::world, row.point};
    core::Joint hinge{core::JointType::hinge, 1, 0, row.point};
    hinge.axis = {0, -1, 0};
    core::JointAngle spring;
    spring.stiffness = stiffness, spring.target = target;
    hinge.angles = {spring};
    scene.joints = {fixed, hinge};
    RunRequest request;
    request.scene = &scene;
    request.setup.dt = duration, request.steps = request.every = 1;
    const RunOutcome outcome = run(parse_engine("in-house", default_engines(binary_dir)), request);
    ASSERT_TRUE(outcome.recording) << outcome.reason;
    const core::State& end = outcome.recording->states.back();
    const double angle = target * (1 - std::cos(std::sqrt(stiffness / inertia) * duration));
    EXPECT_NEAR(end[1].orientation.angularDistance(core::Quaternion::Identity()), angle, 1e-9) << row.inertia;
    EXPECT_LT(end[0].angular_velocity.norm(), 1e-9) << row.inertia;
  }
}

}  // namespace
}  // namespace cylon::process
