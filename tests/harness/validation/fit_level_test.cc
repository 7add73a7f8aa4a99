// The levels of what a fit says, on synthetic experiments of ten throws.  tests/levels does the same a thousand times.
#include "harness/tracking/statistics/proportion.h"
#include "tests/levels/levels.h"

#include <gtest/gtest.h>

namespace cylon::validation {
namespace {

constexpr int experiments = 60;

// Of `trials` with a level of 95 %, fewer than this many hits have a probability below 1e-4: binomial law.
int least_hits(int trials) {
  int hits = trials;
  while (
      statistics::proportion_interval(static_cast<std::size_t>(hits), static_cast<std::size_t>(trials), 1e-4)
          .high >= 0.95)
    --hits;
  return hits + 1;
}

struct Level {
  const char* name;
  bool right;  // the uncertainties are, so that a model is refused in one of twenty experiments
};

class Levels : public testing::TestWithParam<Level> {};

TEST_P(Levels, IntervalsHoldTheTruth) {
  const std::vector<levels::Case> cases = levels::ball_cases();
  const levels::Case& what = levels::find(cases, GetParam().name);
  std::vector<int> held(what.truth.size(), 0), between = held;
  int told = 0;
  for (int seed = 0; seed < experiments; ++seed) {
    const levels::Trial trial = levels::trial(what, static_cast<std::uint64_t>(seed));
    for (std::size_t j = 0; j < held.size(); ++j)
      held[j] += trial.held[j], between[j] += trial.held_between[j];
    told += trial.told;
  }
  for (std::size_t j = 0; j < held.size(); ++j) {
    EXPECT_GE(held[j], least_hits(experiments)) << what.like.parameters[j].name;
    EXPECT_GE(between[j], least_hits(experiments)) << what.like.parameters[j].name;
  }
  if (GetParam().right) {
    EXPECT_LE(told, experiments - least_hits(experiments));
  }
}

INSTANTIATE_TEST_SUITE_P(Validation, Levels,
                         testing::Values(Level{"ball", true}, Level{"ball, in steps", false}),
                         [](const auto& which) { return which.index == 0 ? "Smooth" : "InSteps"; });

TEST(LevelsOfWrongEngines, AreTold) {
  const std::vector<levels::Case> cases = levels::ball_cases();
  for (const char* wrong : {"ball, pyramid", "ball, no restitution", "ball, inertia +10 %"}) {
    int told = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed)
      told += levels::trial(levels::find(cases, wrong), seed).told;
    EXPECT_GE(told, 8) << wrong;
  }
}

}  // namespace
}  // namespace cylon::validation
