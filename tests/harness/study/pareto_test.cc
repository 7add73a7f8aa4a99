// Pareto fronts: of points drawn by hand, and of random points against the definition.
#include "harness/study/pareto.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace cylon::study {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Pareto, MarksTheFrontAndNamesTheCheapestThatDominates) {
  const std::vector<Tradeoff> points = {{3, 0.3}, {1, 1.0}, {2, 0.5}, {4, 0.5}, {5, 0.1}, {6, 0.2}};
  const auto standing = pareto(points);
  const std::vector<bool> front = {true, true, true, false, true, false};
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(standing[i].on_front, front[i]) << i;
  EXPECT_EQ(standing[3].by, 2u);  // as good and cheaper; 0 is better and dearer than 2
  EXPECT_EQ(standing[5].by, 4u);
  for (const std::size_t i : {0u, 1u, 2u, 4u}) EXPECT_FALSE(standing[i].by) << i;
}

TEST(Pareto, EqualPointsShareTheFrontAndEqualErrorsDoNot) {
  const std::vector<Tradeoff> points = {{2, 0.5}, {2, 0.5}, {3, 0.5}, {2, 0.7}};
  const auto standing = pareto(points);
  EXPECT_TRUE(standing[0].on_front);
  EXPECT_TRUE(standing[1].on_front);
  EXPECT_FALSE(standing[2].on_front);  // the same error for more
  EXPECT_FALSE(standing[3].on_front);  // the same cost for less
  EXPECT_EQ(standing[2].by, 0u);
  EXPECT_EQ(standing[3].by, 0u);
}

TEST(Pareto, IgnoresNonFinitePoints) {
  const std::vector<Tradeoff> points = {{nan, 0.0}, {0, nan}, {0, INFINITY}, {7, 0.5}, {INFINITY, 0}};
  const auto standing = pareto(points);
  for (const std::size_t i : {0u, 1u, 2u, 4u}) {
    EXPECT_FALSE(standing[i].on_front) << i;
    EXPECT_FALSE(standing[i].by) << i;
  }
  EXPECT_TRUE(standing[3].on_front);
  EXPECT_TRUE(pareto({}).empty());
}

// The definition itself, over all pairs of a cloud in which ties are common.
TEST(Pareto, AgreesWithTheDefinition) {
  std::mt19937 random(20240607);
  std::uniform_int_distribution<int> die(1, 9);
  std::vector<Tradeoff> points(200);
  for (Tradeoff& p : points) p = {0.5 * die(random), 0.01 * die(random)};
  const auto standing = pareto(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto beats = [&](const Tradeoff& a, const Tradeoff& b) {
      return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
    };
    const bool beaten =
        std::any_of(points.begin(), points.end(), [&](const Tradeoff& p) { return beats(p, points[i]); });
    EXPECT_EQ(standing[i].on_front, !beaten) << i;
    EXPECT_EQ(standing[i].by.has_value(), beaten) << i;
    if (!standing[i].by) continue;
    EXPECT_TRUE(beats(points[*standing[i].by], points[i])) << i;
    EXPECT_TRUE(standing[*standing[i].by].on_front) << i;
  }
}

}  // namespace
}  // namespace cylon::study
