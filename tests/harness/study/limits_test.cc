// The search for limits against answers known beforehand, and theory's numbers against the literature's.
#include "harness/study/limits.h"
#include "harness/study/limits_theory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>

namespace cylon::study {
namespace {

constexpr double half_a_percent = 0.005;  // find_limit's promise

std::function<Probed(double)> breaks_above(double threshold) {
  return [=](double x) { return x <= threshold ? Probed{} : Probed{false, "too much"}; };
}

TEST(FindLimit, AKnownThresholdIsFoundToHalfAPercent) {
  for (const double threshold : {0.0137, 0.7, 2.0, 2.8284271247461903, 63.9, 912.0}) {
    const Range range{.low = 0.01, .high = 1000};
    const Limit limit = find_limit(range, breaks_above(threshold));
    EXPECT_EQ(limit.kind, Limit::Kind::found);
    EXPECT_LE(limit.holds, threshold);
    EXPECT_GT(limit.breaks, threshold);
    EXPECT_NEAR(limit.value(range), threshold, half_a_percent * threshold);
    EXPECT_EQ(limit.what, "too much");
    EXPECT_TRUE(limit.holds_again.empty());
    EXPECT_LE(limit.runs, 30);
  }
}

TEST(FindLimit, FindsSmallestValueDownward) {
  for (const double threshold : {3.3e-7, 0.02, 0.9}) {
    const Range range{.low = 1e-9, .high = 1, .downward = true};
    const Limit limit = find_limit(range, [=](double x) { return Probed{x >= threshold, "too little"}; });
    EXPECT_EQ(limit.kind, Limit::Kind::found);
    EXPECT_GE(limit.holds, threshold);
    EXPECT_LT(limit.breaks, threshold);
    EXPECT_NEAR(limit.value(range), threshold, half_a_percent * threshold);
  }
}

TEST(FindLimit, FindsExactIntegerLimit) {
  for (const int threshold : {1, 2, 7, 37, 63}) {
    const Range range{.low = 1, .high = 64, .whole = true};
    const Limit limit = find_limit(range, breaks_above(threshold + 0.5));
    EXPECT_EQ(limit.kind, Limit::Kind::found);
    EXPECT_EQ(limit.value(range), threshold);
    EXPECT_EQ(limit.breaks, threshold + 1);
  }
}

TEST(FindLimit, ReportsRangeWithoutLimit) {
  const Range range{.low = 1, .high = 500};
  const Limit limit = find_limit(range, [](double) { return Probed{}; });
  EXPECT_EQ(limit.kind, Limit::Kind::none);
  EXPECT_DOUBLE_EQ(limit.holds, 500);
  EXPECT_TRUE(limit.what.empty());
}

TEST(FindLimit, ReportsRangeThatAlwaysFails) {
  const Limit limit = find_limit({.low = 0.25, .high = 500}, [](double) { return Probed{false, "gone"}; });
  EXPECT_EQ(limit.kind, Limit::Kind::nowhere);
  EXPECT_DOUBLE_EQ(limit.breaks, 0.25);
  EXPECT_EQ(limit.what, "gone");
}

// Bisection would answer either edge and hide the other.
TEST(FindLimit, ReportsRecoveryBeyondLimit) {
  const Range range{.low = 0.1, .high = 1000};
  const Limit limit = find_limit(range, [](double x) { return Probed{x < 3 || x > 50, "in the gap"}; });
  EXPECT_EQ(limit.kind, Limit::Kind::found);
  EXPECT_NEAR(limit.value(range), 3, 3 * half_a_percent);
  ASSERT_FALSE(limit.holds_again.empty());
  for (const double x : limit.holds_again) EXPECT_GT(x, 50);
  EXPECT_DOUBLE_EQ(limit.holds_again.back(), 1000);
}

// A window of instability a hundredth wide, far below where it breaks for good.
TEST(FindLimit, FindsNarrowWindowNearTheory) {
  const Range range{.low = 0.01, .high = 100};
  const auto probe = [](double x) { return Probed{!((x > 2 && x < 2.02) || x > 6), "grew"}; };
  EXPECT_NEAR(find_limit(range, probe).value(range), 6, 6 * half_a_percent) << "without theory it is missed";
  const Limit limit = find_limit(range, probe, just_beyond(2.0, range));
  EXPECT_NEAR(limit.value(range), 2, 2 * half_a_percent);
  EXPECT_FALSE(limit.holds_again.empty());
  EXPECT_TRUE(just_beyond(0.0, range).empty());
  EXPECT_TRUE(just_beyond(std::numeric_limits<double>::infinity(), range).empty());
  EXPECT_TRUE(just_beyond(std::nullopt, range).empty());
}

TEST(FindLimit, RejectsInvalidRange) {
  const auto never = [](double) { return Probed{}; };
  EXPECT_THROW(find_limit({.low = 0, .high = 1}, never), std::invalid_argument);
  EXPECT_THROW(find_limit({.low = 2, .high = 1}, never), std::invalid_argument);
  EXPECT_THROW(find_limit({.low = 1, .high = 2, .closeness = 1}, never), std::invalid_argument);
}

// An engine that is a table: each step multiplies the energy of the spring by what the integrator does.
core::Recording oscillator(const core::Scene& scene, double dt, std::int64_t steps, std::int64_t every,
                           double kick) {
  core::Recording r;
  r.dt = dt;
  core::State state = core::initial_state(scene);
  for (std::int64_t n = 0; n <= steps; ++n) {
    if (n % every == 0 || n == steps) r.steps.push_back(n), r.states.push_back(state);
    state[0].velocity -= kick * dt * state[0].position;
    state[0].position += dt * state[0].velocity;
  }
  return r;
}

const Family& family(std::string_view name) {
  for (const Family& row : families())
    if (row.name == name) return row;
  throw std::invalid_argument(std::string(name));
}

// A semi-implicit Euler whose spring is four times as stiff as the scene says has its limit at half of 2.
TEST(Families, TheSpringFamilyMeasuresWhatTheRunnerDoes) {
  const Family& spring = family("spring");
  for (const double kick : {1.0, 4.0}) {
    const Runner fake = [&](const core::Scene& scene, double dt, std::int64_t steps, std::int64_t every) {
      return oscillator(scene, dt, steps, every, kick);
    };
    const Limit limit = find_limit(spring.range, [&](double x) { return spring.probe(fake, x); });
    EXPECT_NEAR(limit.value(spring.range), 2 / std::sqrt(kick), 0.01) << kick;
  }
}

TEST(Families, NamesAreUniqueAndFailureIsDescribed) {
  std::set<std::string> names;
  for (const Family& row : families()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_GT(std::string(row.breaks).size(), 10u) << row.name;
    EXPECT_LT(row.range.low, row.range.high) << row.name;
  }
  EXPECT_GE(names.size(), 14u);
}

TEST(Theory, StabilityLimitsOfTheTextbooks) {
  const struct {
    const char* integrator;
    double limit, within;
    const char* source;
  } table[] = {
      {"explicit-euler", 0, 0, "|1 + ih| > 1"},
      {"lie-trotter", 2, 1e-9, "trace 2 - h^2"},
      {"semi-implicit-euler", 2, 1e-9, "the same"},
      {"velocity-verlet", 2, 1e-9, "the same trace"},
      {"stormer-verlet", 2, 1e-9, "the same trace"},
      {"rk4", 2 * std::numbers::sqrt2, 1e-6, "|R(ih)|^2 = 1 - h^6/72 + h^8/576"},
      {"yoshida4", 1.5734, 1e-3, "Hairer, Lubich, Wanner, Geometric Numerical Integration"},
  };
  for (const auto& row : table) {
    const auto limit = stable_oscillation(row.integrator);
    ASSERT_TRUE(limit) << row.integrator;
    EXPECT_NEAR(*limit, row.limit, row.within) << row.integrator << ": " << row.source;
  }
  EXPECT_FALSE(stable_oscillation("auto"));
}

// Every matrix is a step of x'' = -x: determinant 1 where symplectic, and of its order.
TEST(Theory, StepMatricesHaveTheirOrders) {
  const struct {
    const char* integrator;
    int order;
  } table[] = {{"explicit-euler", 1}, {"lie-trotter", 1}, {"velocity-verlet", 2},
               {"stormer-verlet", 2}, {"rk4", 4},         {"yoshida4", 4},
               {"yoshida6", 6},       {"bm4", 4},         {"rkn4", 4}};
  for (const auto& row : table) {
    const auto matrix = step_matrix(row.integrator);
    ASSERT_TRUE(matrix) << row.integrator;
    const auto error = [&](double h) {
      Eigen::Matrix2d exact;
      exact << std::cos(h), std::sin(h), -std::sin(h), std::cos(h);
      return ((*matrix)(h)-exact).norm();
    };
    EXPECT_NEAR(std::log2(error(0.4) / error(0.2)), row.order + 1, 0.35) << row.integrator;
  }
}

TEST(Theory, DampingAndLongRuns) {
  EXPECT_DOUBLE_EQ(*stable_damping("semi-implicit-euler"), 2);
  EXPECT_NEAR(*stable_damping("explicit-euler"), 2, 1e-9);
  EXPECT_NEAR(*stable_damping("rk4"), 2.7852935634, 1e-6);
  EXPECT_FALSE(stable_damping("auto"));
  // Velocity Verlet turns by 2 asin(h/2) a step: the phase is off by n (2 asin(h/2) - h).
  const double h = 0.1, lag = 2 * std::asin(h / 2) - h;
  EXPECT_NEAR(*steps_until("velocity-verlet", h, 0.5), 2 * std::asin(0.25) / lag, 0.01 * 0.5 / lag);
  EXPECT_TRUE(std::isinf(*steps_until("rk4", 0.001, 0.5)));
}

}  // namespace
}  // namespace cylon::study
