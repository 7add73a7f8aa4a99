// Gimbals that pass close to parallel axes in fixed steps: the diagnostic gimbal-passed.
#include "engine/gimbal_watch.h"

#include "tests/engine/fixtures.h"
#include "tests/engine/joint_scenes.h"
#include "tests/engine/mixed_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace cylon::engine {
namespace {

Model towards_parallel(std::uint32_t number, bool to_world) {
  Dice dice(number);
  const Real towards = dice.between(2, 4), about_axis = dice.between(Real(-1.4), Real(1.4));
  return gimbal_towards_parallel(to_world, towards, about_axis, dice.between(Real(0.1), Real(0.4)));
}

bool says(const World& world) {
  return std::ranges::any_of(world.diagnostics(),
                             [](const Diagnostic& d) { return d.kind == DiagnosticKind::gimbal_passed; });
}

// Whether it says so in the end.
bool says(const Model& model, const Options& options, int steps) {
  bool said = false;
  run(model, options, steps, [&](const World& world) { said = says(world); });
  return said;
}

struct Way {
  const char* name;
  bool constraints;
};
class GimbalsInFixedSteps : public testing::TestWithParam<Way> {};

// Without the diagnostic, steps of 1/64 s of rk4 are right to their usual error.
TEST_P(GimbalsInFixedSteps, AreRightUnlessSaid) {
  int said = 0;
  for (std::uint32_t number = 0; number < 40; ++number) {
    const Model model = towards_parallel(number, number % 2 == 0);
    Options options = with("rk4", 1. / 64);
    options.constraints = GetParam().constraints;
    if (says(model, options, 64)) {
      ++said;
      continue;
    }
    const auto right = run(model, with("rk8", 1. / 4096), 4096).motions;
    EXPECT_LT(distance(run(model, options, 64).motions, right), 0.02) << number;
  }
  EXPECT_GE(said, 10);
  EXPECT_LE(said, 20);
}

// Shorter steps resolve more of them.
TEST_P(GimbalsInFixedSteps, AreResolvedByShorterSteps) {
  int said = 0;
  for (std::uint32_t number = 0; number < 40; ++number) {
    Options options = with("rk4", 1. / 1024);
    options.constraints = GetParam().constraints;
    said += static_cast<int>(says(towards_parallel(number, number % 2 == 0), options, 1024));
  }
  EXPECT_LE(said, 4);
}

INSTANTIATE_TEST_SUITE_P(Ways, GimbalsInFixedSteps,
                         testing::Values(Way{"coordinates", false}, Way{"constraints", true}),
                         [](const auto& way) { return way.param.name; });

// The stepping path has it, too; nothing touches here.
TEST(GimbalWatch, SpeaksInTheSteppingPath) {
  int said = 0;
  for (std::uint32_t number = 0; number < 40; ++number) {
    Model model = towards_parallel(number, number % 2 == 0);
    model.shapes.assign(model.bodies.size(), Sphere{Real(0.1)});
    model.surfaces.assign(model.bodies.size(), 0);
    model.planes.push_back({Vector3::UnitY(), -100});
    model.plane_surfaces = {0};
    model.surface_count = 1, model.materials = {{0, 0}};
    Options options = with("auto", 1. / 64);
    options.path = "stepping";
    said += static_cast<int>(says(model, options, 64));
    model.forces.coordinate_laws.clear();  // a ball
    EXPECT_FALSE(says(model, options, 64)) << number;
  }
  EXPECT_GE(said, 5);
}

// Adaptive integrators shorten their steps.
TEST(GimbalWatch, IsSilentInAdaptiveSteps) {
  for (std::uint32_t number = 0; number < 10; ++number)
    EXPECT_FALSE(says(towards_parallel(number, number % 2 == 0), with("auto", 1. / 64), 64)) << number;
}

// Fast turns about the axes themselves are far from the singularity.
TEST(GimbalWatch, IsSilentInFastTurnsAboutItsAxes) {
  for (const bool about_second : {false, true}) {
    JointScene s = joint_scene(joint_types::gimbal, true);
    CoordinateLaw law;
    law.at = s.angle(about_second), law.damping = Real(1e-3);
    s.model.forces.coordinate_laws.push_back(law);
    GimbalWatch watch(s.model);
    std::vector<Motion> motions = s.model.motions;
    for (int i = 0; i < 5; ++i) {
      motions[0].orientation =
          exponential(Vector3(Real(2.5) * (about_second ? s.second : s.axis))) * motions[0].orientation;
      // The second axis goes with the body.
      EXPECT_EQ(watch.look(motions), 0) << i;
      if (!about_second) s.second = exponential(Vector3(Real(2.5) * s.axis)) * s.second;
    }
  }
}

}  // namespace
}  // namespace cylon::engine
