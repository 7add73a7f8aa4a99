// Orders and floors of synthetic errors: C dt^p + floor, with scatter, failed runs and NaN.
#include "harness/study/order_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace cylon::study {
namespace {

constexpr double eps = 0x1p-52;

// C dt^p + rounding eps_0/dt over halving steps from 1/8 s, each up to a tenth off.
std::vector<StepError> made(double order, double constant, double rounding, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> scatter(0.9, 1.1);
  std::vector<StepError> points;
  for (int i = 0; i < count; ++i) {
    const double dt = std::ldexp(0.125, -i);
    points.push_back({dt, scatter(random) * constant * std::pow(dt, order) + scatter(random) * rounding});
  }
  return points;
}

struct Case {
  double order, constant, floor;
  int count;
};

class MadeErrors : public testing::TestWithParam<Case> {};

// Four points a factor of two apart, a tenth off each: the slope of the ends is off by 0.2/(3 ln 2) at most,
// 0.1.
TEST_P(MadeErrors, RecoverOrderAndFloor) {
  const auto [order, constant, floor, count] = GetParam();
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const OrderFit fit = fit_order(made(order, constant, floor, count, seed), 0, eps);
    ASSERT_TRUE(fit.order) << seed;
    // Above twenty times the floor the floor adds a twentieth to the last error.
    EXPECT_NEAR(*fit.order, order, 0.15) << seed;
    ASSERT_EQ(fit.floor.has_value(), floor > 0) << seed;
    if (floor == 0) continue;
    EXPECT_NEAR(std::log10(*fit.floor / floor), 0, 0.3) << seed;
    EXPECT_TRUE(fit.rounding);
    const double meet = std::pow(floor / constant, 1 / order);  // where both parts are equal
    EXPECT_LT(fit.floor_from, 2.5 * meet) << seed;
    EXPECT_GT(fit.floor_from, meet / 5) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(OrdersAndFloors, MadeErrors,
                         testing::Values(Case{1, 2.0, 0, 10}, Case{2, 3.0, 0, 10}, Case{2, 0.7, 3e-9, 22},
                                         Case{4, 5.0, 3e-13, 16}, Case{6, 20.0, 2e-14, 12},
                                         Case{8, 900.0, 4e-14, 10}, Case{4, 1.0, 0, 8}));

TEST(OrderFit, AnErrorThatNeverFallsHasNoOrder) {
  std::vector<StepError> lost;
  for (int i = 0; i < 9; ++i) lost.push_back({std::ldexp(0.1, -i), 3.0 + 0.1 * (i % 3)});
  const OrderFit fit = fit_order(lost, 0, eps);
  EXPECT_FALSE(fit.order);
  EXPECT_FALSE(fit.floor);  // three radians are no rounding
}

TEST(OrderFit, IgnoresFailedRuns) {
  auto points = made(2, 0.4, 0, 9, 3);
  points.insert(points.begin(), {{0.5, 2.9}, {0.25, 3.1}});
  points[4].error = std::nan("");
  points.push_back({std::ldexp(0.125, -9), INFINITY});
  const OrderFit fit = fit_order(points, 0, eps);
  ASSERT_TRUE(fit.order);
  EXPECT_NEAR(*fit.order, 2, 0.15);
}

TEST(OrderFit, TruthErrorIsTheFloor) {
  std::vector<StepError> exact;
  for (int i = 0; i < 6; ++i) exact.push_back({std::ldexp(0.1, -i), i % 2 ? 2e-15 : 0.0});
  const OrderFit fit = fit_order(exact, 1e-14, eps);
  EXPECT_FALSE(fit.order);
  ASSERT_TRUE(fit.floor);
  EXPECT_EQ(fit.floor_from, 0.1);
  EXPECT_TRUE(fit.rounding);
}

// An error that stalls at a thousandth is no rounding, and is not called one.
TEST(OrderFit, StallIsNotRoundingFloor) {
  const OrderFit fit = fit_order(made(1, 8.0, 1e-3, 16, 5), 0, eps);
  ASSERT_TRUE(fit.floor);
  EXPECT_FALSE(fit.rounding);
  ASSERT_TRUE(fit.order);
  EXPECT_NEAR(*fit.order, 1, 0.15);
}

TEST(OrderFit, OnePointOrNoneIsNoOrder) {
  EXPECT_FALSE(fit_order({}, 0, eps).order);
  const std::vector<StepError> one = {{0.1, 0.01}};
  EXPECT_FALSE(fit_order(one, 0, eps).order);
  EXPECT_FALSE(fit_order(one, 0, eps).floor);
}

}  // namespace
}  // namespace cylon::study
