// A chain of 44 links that hangs straight down and still was followed for 0.28 s and no farther: the bodies'
// speeds were the rounding of the joints' forces, 1e-13 m/s, the tolerance was relative to these, and no step
// was short enough.  A speed is small against what gravity gives over the chain's length.
#include "harness/process/client.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <filesystem>

namespace cylon::process {
namespace {

core::Scene chain(int links) {
  core::Scene scene;
  scene.forces = {core::UniformGravity{}};
  for (int i = 0; i < links; ++i) {
    core::Body link;
    link.name = fmt::format("link{}", i);
    link.mass = 1.3;
    link.inertia = core::Vector3(0.005, 0.002, 0.005).asDiagonal();
    link.initial.position = {0, -0.1 - 0.2 * i, 0};
    scene.bodies.push_back(link);
    core::Joint joint;
    joint.body = i, joint.to = i == 0 ? core::world : i - 1;
    joint.point = {0, -0.2 * i, 0};
    scene.joints.push_back(joint);
  }
  return scene;
}

TEST(ChainAtRest, StaysAtRestForAnyLength) {
  for (const int links : {3, 32, 44, 60}) {
    const core::Scene scene = chain(links);
    RunRequest request;
    request.scene = &scene;
    request.setup.dt = 1. / 60;
    request.steps = request.every = 54;
    const RunOutcome outcome = run(parse_engine("in-house", default_engines(binary_dir)), request);
    ASSERT_TRUE(outcome.recording) << outcome.reason;
    EXPECT_TRUE(outcome.recording->remarks.empty()) << links << ": " << outcome.recording->remarks.front();
    // A hundred roundings of the chain's length.
    for (int i = 0; i < links; ++i) {
      const auto k = static_cast<std::size_t>(i);
      EXPECT_LE((outcome.recording->states.back()[k].position - scene.bodies[k].initial.position).norm(),
                100 * 2.2e-16 * 0.2 * links)
          << links << " links, link " << i;
    }
  }
}

// A body keeps no angular momentum about an axis without inertia: the engine dropped such a turn and its
// first state was not the scene's.  It says so now.
TEST(SpinWithoutInertia, IsRejectedWithBodyName) {
  core::Scene scene;
  core::Body needle;
  needle.name = "needle";
  needle.mass = 1;
  needle.inertia = core::Vector3(1e-14, 1, 1).asDiagonal();
  needle.initial.angular_velocity = {0.5, 1.5, 0.3};
  scene.bodies = {needle};
  RunRequest request;
  request.scene = &scene;
  request.setup.dt = 0.01;
  request.steps = 1;
  const auto engine = parse_engine("in-house", default_engines(binary_dir));
  const RunOutcome refused = run(engine, request);
  EXPECT_EQ(refused.status, results::Status::unsupported);
  EXPECT_NE(refused.reason.find("body 'needle' turns at 0.5 rad/s"), std::string::npos) << refused.reason;
  scene.bodies[0].initial.angular_velocity.x() = 0;
  EXPECT_EQ(run(engine, request).status, results::Status::pass);
}

}  // namespace
}  // namespace cylon::process
