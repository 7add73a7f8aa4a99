// `cylon hunt` found it (seed 4242, scene 335): a spring along the angle of a joint turns bodies about their own centres, and
// the rest of them is held, or balances.  What the joints leave of forces and torques there is rounding; the error-controlled
// integrator measured errors by it, found no step small enough, and every state was NaN.
#include "harness/process/client.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::process {
namespace {

struct Row {
  bool held;             // the first body is fixed to the world
  double inertia;        // of the first body [kg m^2]
  core::Vector3 centre;  // of both bodies [m]
  core::Vector3 point;   // of the joint between them [m]
  core::Vector3 axis;
};

core::Body ball(const char* name, const Row& row, double inertia) {
  core::Body body;
  body.name = name, body.inertia = inertia * core::Matrix3::Identity();
  body.initial.position = row.centre;
  return body;
}

// J d2a/dt2 = -k (a - a0) from rest, a the angle between both, J its reduced inertia: a = a0 (1 - cos(sqrt(k/J) t)).
TEST(SpringOnAHeldBody, SwingsAboutItsTarget) {
  constexpr double inertia = 0.064, stiffness = 121.173, target = 0.087, duration = 0.1;
  const core::Vector3 zero(0, 0, 0), aside(0.3, -0.2, 0.5), along_z(0, 0, 1), down(0, -1, 0);
  const core::Vector3 tilted = core::Vector3(-0.542, -0.685, 0).normalized();
  const Row rows[] = {{true, 0.036, zero, zero, down},      {true, 0.064, zero, zero, down},
                      {true, 1.7, zero, zero, down},        {true, 0.036, aside, aside, down},
                      {false, 0.036, zero, zero, down},     {false, 0.036, zero, along_z, tilted},
                      {false, 0.064, zero, along_z, tilted}};
  for (const Row& row : rows) {
    SCOPED_TRACE(testing::Message() << row.held << ' ' << row.inertia << ' ' << row.axis.transpose());
    core::Scene scene;
    scene.bodies = {ball("first", row, row.inertia), ball("second", row, inertia)};
    core::Joint planar{core::JointType::planar, 1, 0, row.point};
    planar.axis = row.axis, planar.axis_2 = row.axis.unitOrthogonal();
    core::JointAngle spring;
    spring.stiffness = stiffness, spring.target = target;
    planar.angles = {spring};
    scene.joints = {planar};
    if (row.held) scene.joints.push_back({core::JointType::fixed, 0, core::world, row.centre});
    RunRequest request;
    request.scene = &scene;
    request.setup.dt = duration, request.steps = request.every = 1;
    const RunOutcome outcome = run(parse_engine("in-house", default_engines(binary_dir)), request);
    ASSERT_TRUE(outcome.recording) << outcome.reason;
    const core::State& end = outcome.recording->states.back();
    const double reduced = row.held ? inertia : inertia * row.inertia / (inertia + row.inertia);
    const double angle = target * (1 - std::cos(std::sqrt(stiffness / reduced) * duration));
    EXPECT_NEAR(end[1].orientation.angularDistance(end[0].orientation), angle, 1e-9);
    if (row.held) {
      EXPECT_LT(end[0].angular_velocity.norm(), 1e-9);
    }
  }
}

}  // namespace
}  // namespace cylon::process
