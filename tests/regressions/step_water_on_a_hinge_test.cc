// An attack on joints found it: water of mode `step` damps a body's own angular momentum, and took that about the pivot where a
// joint left the body its reduced coordinates, with no remark.
#include "harness/process/client.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::process {
namespace {

// A body of mass m, its centre s from a hinge, I about its centre, under step water of buoyancy b: with J = I + m s^2
//   J a'' = -I a' + (b - m g) s cos a
double rate_at(double t, double rate) {
  constexpr double m = 2, s = 0.2, inertia = 0.2, b = 5, g = 9.81, whole = inertia + m * s * s;
  const auto change = [&](double a, double w) {
    return (-inertia * w + (b - m * g) * s * std::cos(a)) / whole;
  };
  double a = 0;
  constexpr int steps = 20000;
  const double h = t / steps;
  for (int i = 0; i < steps; ++i) {
    const double a1 = rate, w1 = change(a, rate), a2 = rate + h / 2 * w1, w2 = change(a + h / 2 * a1, a2),
                 a3 = rate + h / 2 * w2, w3 = change(a + h / 2 * a2, a3), a4 = rate + h * w3,
                 w4 = change(a + h * a3, a4);
    a += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4), rate += h / 6 * (w1 + 2 * w2 + 2 * w3 + w4);
  }
  return rate;
}

TEST(StepWaterOnAHinge, DampsTheSpinAboutTheCentre) {
  core::Scene scene;
  core::Body body;
  body.name = "arm", body.mass = 2, body.inertia = 0.2 * core::Matrix3::Identity();
  body.initial.position = {0.2, 0.1, 0};
  body.initial.velocity = {0, 0.4, 0}, body.initial.angular_velocity = {0, 0, 2};
  scene.bodies = {body};
  core::Joint hinge{core::JointType::hinge, 0, core::world, {0, 0.1, 0}};
  hinge.axis = {0, 0, 1};
  scene.joints = {hinge};
  scene.forces.emplace_back(core::UniformGravity{{0, -9.81, 0}});
  core::Water water;
  water.level = 5, water.buoyancy = 5, water.mode = "step";
  scene.forces.emplace_back(water);
  RunRequest request;
  request.scene = &scene;
  request.setup.dt = 0.5, request.steps = request.every = 1;
  for (const char* engine : {"in-house", "in-house/joints=constraints"}) {
    const RunOutcome outcome = run(parse_engine(engine, default_engines(binary_dir)), request);
    ASSERT_TRUE(outcome.recording) << outcome.reason;
    EXPECT_NEAR(outcome.recording->states.back()[0].angular_velocity.z(), rate_at(0.5, 2), 1e-8) << engine;
  }
}

}  // namespace
}  // namespace cylon::process
