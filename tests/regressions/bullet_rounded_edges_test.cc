// Bullet's boxes and cylinders were rounded: Bullet keeps a margin of 0.04 m inside them, and what asks for
// their support function (a plane under a cylinder, a ball at a box) sees edges of that radius.  A cylinder
// tilted by 45 degrees met the floor 0.04 (sqrt 2 - 1) = 17 mm too late, a ball the corner of a box 22 mm.
// The adapter sets the margin to zero.
#include "harness/core/observable.h"
#include "harness/process/client.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::process {
namespace {

TEST(BulletRoundedEdges, ATiltedCylinderMeetsTheFloorWithItsEdge) {
  constexpr double speed = 1, dt = 1e-3;
  core::Scene scene;
  core::Body can;
  can.name = "can";
  can.shape = core::Cylinder{0.5, 1.0};
  can.collide = true;
  can.initial.orientation = core::Quaternion(std::cos(M_PI / 8), std::sin(M_PI / 8), 0, 0);
  can.initial.position = {0, std::sqrt(0.5) + 0.1 + 0.37 * dt, 0};  // its edge 0.1 m above
  can.initial.velocity = {0, -speed, 0};
  scene.bodies = {can};
  scene.planes = {{"floor", core::Vector3::UnitY(), 0}};
  scene.materials = {{{"*", "*"}, 1, 0}};
  for (const char* id : {"bullet", "bullet-float", "bullet-multibody", "bullet-multibody-float"}) {
    RunRequest request;
    request.scene = &scene;
    request.setup.dt = dt;
    request.steps = 200;
    const RunOutcome outcome = run(parse_engine(id, default_engines(binary_dir)), request, {60, 60, 0});
    ASSERT_TRUE(outcome.recording) << id << ": " << outcome.reason;
    double deepest = 0;
    for (const core::State& state : outcome.recording->states)
      deepest = std::min(deepest, core::gap(scene, {0, core::world, 0}, state));
    EXPECT_LT(deepest, 0) << id << ": never there";
    EXPECT_GE(deepest, -2 * speed * dt) << id;  // noticed within a step, answered in the next
  }
}

}  // namespace
}  // namespace cylon::process
