// A body on the seed's water, whose lift switches on below the surface: an error-controlled run looked for the next
// switch from the place of the last one as if that were neither above nor below.  Where the body came up again within an
// eighth of a step, and steps under constant forces are long, it was not seen: the lift acted on above the water, and
// the body went up 45 m in 3 s in place of swinging by 1 cm.
#include "harness/process/client.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::process {
namespace {

// Without drag the swing about the surface has no loss: as high again after each period, at rest.
//   above: h = g t^2/2;  below, lift 2 m g: the same upwards.  Period 4 sqrt(2 h/g).
TEST(SwitchAfterASwitch, IsSeen) {
  constexpr double height = 0.01, g = 9.81, mass = 1.3, speed = 0.4;
  core::Scene scene;
  core::Body body;
  body.name = "swimmer";
  body.mass = mass;
  body.inertia = core::Vector3(0.1, 0.2, 0.25).asDiagonal();
  body.initial.position = {0, 2 + height, 0};
  body.initial.velocity = {speed, 0, 0};
  scene.bodies.push_back(body);
  core::Water water;
  water.level = 2, water.buoyancy = 2 * mass * g, water.mode = "step";
  scene.forces = {core::UniformGravity{core::Vector3(0, -g, 0)}, water};
  const double period = 4 * std::sqrt(2 * height / g);
  for (const char* id : {"in-house", "in-house/integrator=dop853"}) {
    for (const double part : {0.05, 0.5, 1., 5.}) {
      RunRequest request;
      request.scene = &scene;
      request.setup.dt = part * period;
      request.steps = request.every = std::lround(10 / part);
      const RunOutcome outcome = run(parse_engine(id, default_engines(binary_dir)), request);
      ASSERT_TRUE(outcome.recording) << id << ": " << outcome.reason;
      const core::BodyState& end = outcome.recording->states.back()[0];
      EXPECT_NEAR(end.position.y(), 2 + height, 1e-8) << id << part;
      EXPECT_NEAR(end.position.x(), speed * 10 * period, 1e-8) << id << part;
    }
  }
}

}  // namespace
}  // namespace cylon::process
