// A ball far along a floor did not fall: what counts as touching grew with the ball's distance from the
// origin, though only the height above the floor is rounded.  At 10^7 m in single precision that was ten
// metres.
#include "harness/process/client.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

namespace cylon::process {
namespace {

std::vector<core::State> bounced_at(double x, const char* engine) {
  core::Scene scene;
  core::Body ball;
  ball.name = "ball", ball.mass = 1.3;
  ball.shape = core::Sphere{0.5};
  ball.inertia = core::Matrix3::Identity() * 0.13;
  ball.initial.position = {x, 2.5, -x};
  ball.collide = true;
  scene.bodies = {ball};
  scene.planes = {{"floor", core::Vector3::UnitY(), 0}};
  scene.materials = {{{"*", "*"}, 0.8, 0}};
  scene.forces = {core::UniformGravity{}};
  RunRequest request;
  request.scene = &scene;
  request.setup.dt = 1. / 240;
  request.steps = 480;
  const RunOutcome outcome = run(parse_engine(engine, default_engines(binary_dir)), request);
  EXPECT_TRUE(outcome.recording) << outcome.reason;
  return outcome.recording ? outcome.recording->states : std::vector<core::State>();
}

TEST(FarAlongAFloor, BouncesAsAtTheOrigin) {
  for (const char* engine : {"in-house", "in-house-float"}) {
    const auto near = bounced_at(0, engine), far = bounced_at(1e7, engine);
    ASSERT_EQ(near.size(), far.size());
    ASSERT_GT(near.size(), 400u);
    for (std::size_t i = 0; i < near.size(); ++i) {
      EXPECT_EQ(near[i][0].position.y(), far[i][0].position.y()) << engine << ", sample " << i;
      EXPECT_EQ(far[i][0].position.x(), 1e7);
    }
    EXPECT_LT(near[170][0].position.y(), 1) << "it fell";  // the first touch is at 0.639 s, sample 153
    EXPECT_GT(near[270][0].position.y(), 1.5) << "and came back";
  }
}

}  // namespace
}  // namespace cylon::process
