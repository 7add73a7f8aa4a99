// The yardstick on runs whose errors are known, and the ladders of steps.
#include "harness/study/yardstick.h"

#include "harness/core/input_error.h"
#include "harness/study/ladder.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cylon::study {
namespace {

scenario::Scenario shipped(const std::string& name) {
  return scenario::load(std::string(source_dir) + "/scenarios/" + name + ".toml");
}

// The truth itself as a run, each state moved by `off`.
core::Recording truth_as_run(const scenario::Scenario& scenario, std::int64_t steps, std::int64_t every,
                             const core::Vector3& off) {
  core::Recording run;
  run.dt = scenario.duration / static_cast<double>(steps);
  for (std::int64_t k = 0; k <= steps; k += every) {
    run.steps.push_back(k);
    run.states.push_back(scenario.claims.front().truth->state(static_cast<double>(k) * run.dt));
    if (k > 0) run.states.back()[0].position += off;
  }
  return run;
}

// A hundredth of a metre off all the time, of a motion that spans 3 m.
TEST(Yardstick, MeasuresErrorRelativeToMotion) {
  const scenario::Scenario scenario = shipped("spring_orbit");
  const Yardstick yardstick(scenario, 100);
  EXPECT_EQ(yardstick.measures()[yardstick.principal()].name, "trajectory");
  const auto exact = yardstick.errors(truth_as_run(scenario, 20000, 1, {0, 0, 0}));
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_LT(exact[i], 1e-9) << yardstick.measures()[i].name;
  const auto off = yardstick.errors(truth_as_run(scenario, 20000, 1, {0.006, 0, 0.008}));
  EXPECT_NEAR(off[yardstick.find("trajectory")], 0.01 / 3, 1e-4);
  EXPECT_NEAR(off[yardstick.find("position")], 0.01 / 3, 1e-4);
  EXPECT_GT(off[yardstick.find("energy")], 1e-3);  // the spring is stretched otherwise
}

TEST(Yardstick, RejectsNaN) {
  const scenario::Scenario scenario = shipped("projectile");
  const Yardstick yardstick(scenario, 20);
  core::Recording run = truth_as_run(scenario, 800, 40, {0, 0, 0});
  run.states[7][0].velocity.y() = std::numeric_limits<double>::quiet_NaN();
  for (const double e : yardstick.errors(run)) EXPECT_TRUE(std::isnan(e));
}

TEST(Yardstick, UnknownMeasureSuggestsNearest) {
  const scenario::Scenario scenario = shipped("projectile");
  const Yardstick yardstick(scenario, 20);
  EXPECT_THROW(yardstick.find("energi"), core::InputError);
}

TEST(Conserved, FollowsFromPartsOfTheScene) {
  using core::Quantity;
  const auto of = [](const char* name) { return conserved(shipped(name).scene); };
  EXPECT_EQ(of("spring_orbit"), (std::vector{Quantity::energy}));  // its pin takes up momentum
  EXPECT_EQ(of("kepler"),
            (std::vector{Quantity::energy, Quantity::linear_momentum, Quantity::angular_momentum}));
  EXPECT_EQ(of("projectile_drag"), (std::vector<Quantity>{}));
  EXPECT_EQ(of("bouncing_sphere_elastic"), (std::vector{Quantity::energy}));
  EXPECT_EQ(of("bouncing_sphere"), (std::vector<Quantity>{}));
  EXPECT_EQ(of("rotating_frame"), (std::vector<Quantity>{}));
}

TEST(Ladder, HasMultiplesOfItsSamplesAroundTheNominalStep) {
  for (const char* name :
       {"projectile", "bouncing_sphere", "dzhanibekov", "heavy_top", "double_pendulum_rods"}) {
    const scenario::Scenario scenario = shipped(name);
    const Ladder steps = ladder(scenario, 12, 1 << 18);
    EXPECT_GE(steps.samples, 16) << name;
    EXPECT_TRUE(std::is_sorted(steps.steps.begin(), steps.steps.end()));
    for (const std::int64_t n : steps.steps) EXPECT_EQ(n % steps.samples, 0) << name;
    EXPECT_LE(steps.steps.front(), nominal_steps(scenario)) << name;
    EXPECT_GT(steps.steps.back(), nominal_steps(scenario)) << name;
    EXPECT_LE(steps.steps.back(), 1 << 18) << name;
  }
}

TEST(Ladder, GivenStepsNeedCommonTimes) {
  const scenario::Scenario scenario = shipped("bouncing_sphere");
  const Ladder steps = ladder(scenario, std::vector<double>{1.0 / 60, 1.0 / 240, 0.01});
  EXPECT_EQ(steps.steps, (std::vector<std::int64_t>{300, 500, 1200}));
  EXPECT_EQ(steps.samples, 100);
  EXPECT_THROW(ladder(scenario, std::vector<double>{5.0 / 7, 5.0 / 11}), core::InputError);
  EXPECT_THROW(ladder(scenario, std::vector<double>{0.3}), core::InputError);
}

}  // namespace
}  // namespace cylon::study
