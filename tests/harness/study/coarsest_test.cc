// The search for the coarsest sufficient setting, against an exhaustive search.
#include "harness/study/coarsest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

namespace cylon::study {
namespace {

// Errors of a row of 60 steps, each 2^(1/4) finer: C dt^p + floor, lost above one.
std::vector<double> law(double order, double constant, double floor) {
  std::vector<double> errors;
  for (int i = 0; i < 60; ++i) {
    const double e = constant * std::pow(std::exp2(-0.25 * i), order) + floor;
    errors.push_back(e > 1 ? NAN : e);
  }
  return errors;
}

double digits(double order) { return 0.25 * order * std::log10(2.0); }

TEST(Coarsest, AgreesWithExhaustiveSearch) {
  for (const double order : {1.0, 2.0, 4.0, 8.0})
    for (const double constant : {0.2, 30.0})
      for (const double target : {1e-1, 3e-3, 1e-5, 1e-9})
        for (const double floor : {0.0, 1e-12, 1e-4}) {
          const std::vector<double> errors = law(order, constant, floor);
          std::size_t runs = 0;
          std::map<std::size_t, double> seen;
          const Coarsest found = coarsest([&](std::size_t i) { return ++runs, errors[i]; }, errors.size(),
                                          target, digits(order), 12, seen);
          std::optional<std::size_t> first;
          for (std::size_t i = errors.size(); i-- > 0 && errors[i] <= target;) first = i;
          EXPECT_EQ(found.pick, first) << order << ' ' << constant << ' ' << target << ' ' << floor;
          EXPECT_LE(runs, 14u) << order << ' ' << constant << ' ' << target << ' ' << floor;
          if (!found.pick) continue;
          EXPECT_EQ(found.error, errors[*found.pick]);
        }
}

TEST(Coarsest, ReportsBestErrorWhenNoStepSuffices) {
  const std::vector<double> errors = law(2, 0.5, 1e-3);
  std::map<std::size_t, double> seen;
  const Coarsest found =
      coarsest([&](std::size_t i) { return errors[i]; }, errors.size(), 1e-6, digits(2), 5, seen);
  EXPECT_FALSE(found.pick);
  EXPECT_NEAR(found.best_error, 1e-3, 1e-5);
}

// Rounding makes a narrow valley, deeper than the law goes, between settings that all miss: the leaps must
// not end beyond it, and a floor twice as high must not be walked step by step.
TEST(Coarsest, FindsNarrowMinimumNearRoundingFloorOnly) {
  for (const double floor : {1.3e-3, 2.7e-3})
    for (const std::size_t valley : {38u, 44u, 52u}) {
      std::vector<double> errors = law(1, 0.5, floor);
      errors[valley] = errors[valley + 1] = 0.6e-3;
      std::size_t runs = 0;
      std::map<std::size_t, double> seen;
      const Coarsest found = coarsest([&](std::size_t i) { return ++runs, errors[i]; }, errors.size(), 1e-3,
                                      digits(1), 12, seen);
      if (floor < 2e-3) {
        EXPECT_EQ(found.pick, valley) << floor;
        EXPECT_LE(runs, 45u);
      } else {
        EXPECT_LE(runs, 14u) << floor;
      }
    }
}

TEST(Coarsest, EvaluatesEachStepOnce) {
  const std::vector<double> errors = law(1, 0.3, 0);
  std::map<std::size_t, double> seen;
  std::map<std::size_t, int> asked;
  for (const double target : {1e-2, 1e-3})
    coarsest([&](std::size_t i) { return ++asked[i], errors[i]; }, errors.size(), target, digits(1), 0, seen);
  for (const auto& [i, times] : asked) EXPECT_EQ(times, 1) << i;
}

TEST(Coarsest, ExactResultLeadsToCoarsestStep) {
  std::map<std::size_t, double> seen;
  const Coarsest found = coarsest([](std::size_t) { return 0.0; }, 40, 1e-3, 1, 30, seen);
  EXPECT_EQ(found.pick, 0u);
}

TEST(Coarsest, SearchEndsWhenAllRunsFail) {
  std::map<std::size_t, double> seen;
  const Coarsest found = coarsest([](std::size_t) { return NAN; }, 40, 1e-3, 1, 3, seen);
  EXPECT_FALSE(found.pick);
  EXPECT_TRUE(std::isinf(found.best_error));
}

}  // namespace
}  // namespace cylon::study
