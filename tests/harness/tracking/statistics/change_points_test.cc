// Steps are placed at their revision, and a flat history has none.
#include "harness/tracking/statistics/change_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace cylon::statistics {
namespace {

struct Step {
  std::size_t at;
  double factor;
};

// ln of the ratio to the anchor at every revision: a level, its steps, and a stray of Student's t with 5
// degrees of freedom, whose deviation is 1.3 `spread`.  The estimate of 40 pairs of processes that stray by 1
// and 3 % strays by 0.2 and 0.7 %.
std::vector<double> ratios(std::size_t count, const std::vector<Step>& steps, double spread,
                           std::mt19937_64& random) {
  std::student_t_distribution<double> t(5);
  std::vector<double> series;
  double level = 0.4;
  for (std::size_t i = 0; i < count; ++i) {
    for (const Step& step : steps)
      if (step.at == i) level += std::log(step.factor);
    series.push_back(level + spread * t(random));
  }
  return series;
}

// What the same history looks like as absolute times: the machine's own level wanders.
std::vector<double> absolute(std::vector<double> series, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  double level = 0;
  for (double& one : series) {
    level = 0.95 * level + 0.02 * normal(random);
    one += level;
  }
  return series;
}

// 800 histories of 200 revisions.  Negative control: absolute times of the same histories are full of steps.
TEST(ChangePoints, FlatHistoriesHaveNone) {
  for (const double spread : {0.002, 0.005, 0.007, 0.01}) {
    std::mt19937_64 random(47);
    std::size_t found = 0, found_in_times = 0;
    for (int history = 0; history < 200; ++history) {
      const std::vector<double> series = ratios(200, {}, spread, random);
      found += change_points(series).size();
      found_in_times += change_points(absolute(series, random)).size();
    }
    std::printf(
        "[ measured ] flat, strays by %.1f %%: %zu change points in 200 ratio histories, %zu in absolute "
        "times\n",
        100 * spread, found, found_in_times);
    EXPECT_EQ(found, 0U) << spread;
    EXPECT_GT(found_in_times, 200U) << spread;
  }
}

struct Placed {
  std::string name;
  double spread;
  std::vector<Step> steps;
  double exact;  ///< Share of the steps that are placed at their revision, at least; 2 off in all but 3 %.
};

class Steps : public testing::TestWithParam<Placed> {};

TEST_P(Steps, AreAtTheirRevision) {
  const Placed& row = GetParam();
  std::mt19937_64 random(53);
  int exact = 0, near = 0, extra = 0;
  for (int history = 0; history < 100; ++history) {
    const auto points = change_points(ratios(200, row.steps, row.spread, random));
    for (const Step& step : row.steps) {
      const auto off = [&](const ChangePoint& p) {
        return p.index < step.at ? step.at - p.index : p.index - step.at;
      };
      const auto closest = std::min_element(points.begin(), points.end(),
                                            [&](const auto& a, const auto& b) { return off(a) < off(b); });
      if (closest == points.end() || off(*closest) > 2) continue;
      ++near;
      exact += closest->index == step.at ? 1 : 0;
      // 99 % of a normal interval; five are asked for of the 1.2 expected deviations, as the tails are
      // heavier.
      EXPECT_NEAR(closest->magnitude, std::log(step.factor), 5 * row.spread);
      EXPECT_LT(closest->interval.low, closest->magnitude);
      EXPECT_GT(closest->interval.high, closest->magnitude);
      EXPECT_LT(closest->p, 0.001);
    }
    extra += points.size() > row.steps.size() ? 1 : 0;
  }
  const auto all = 100.0 * static_cast<double>(row.steps.size());
  std::printf(
      "[ measured ] strays by %.1f %%, %s: exact %.1f %%, within 2 %.1f %%, false %d of 100 histories\n",
      100 * row.spread, row.name.c_str(), 100 * exact / all, 100 * near / all, extra);
  EXPECT_GE(exact, row.exact * all);
  EXPECT_GE(near, 0.97 * all);
  EXPECT_EQ(extra, 0);
}

const std::vector<Step> staircase = {{40, 1.03}, {90, 1.05}, {150, 1.10}};
// Levels that return at once: no single cut of the whole series divides it well.
const std::vector<Step> zigzag = {{6, 1.03},      {12, 1 / 1.03}, {18, 1.05},
                                  {24, 1 / 1.05}, {30, 1.10},     {36, 1 / 1.10}};
const std::vector<Step> hill = {{60, 1.05}, {75, 1 / 1.05}};
INSTANTIATE_TEST_SUITE_P(
    Injected, Steps,
    testing::Values(Placed{"3 %", 0.002, {{70, 1.03}}, 1}, Placed{"5 %", 0.002, {{70, 1.05}}, 1},
                    Placed{"10 %", 0.002, {{70, 1.10}}, 1}, Placed{"3, 5 and 10 %", 0.002, staircase, 1},
                    Placed{"5 % and back after 15", 0.002, hill, 1},
                    Placed{"3, 5, 10 % and back after 6 each", 0.002, zigzag, 0.99},
                    Placed{"10 % in the last 5", 0.002, {{195, 1.1}}, 1},
                    Placed{"5 % after the first 5", 0.002, {{5, 1.05}}, 1},
                    Placed{"3 %", 0.005, {{70, 1.03}}, 0.9}, Placed{"5 %", 0.005, {{70, 1.05}}, 0.95},
                    Placed{"10 %", 0.005, {{70, 1.10}}, 0.99}, Placed{"3, 5 and 10 %", 0.007, staircase, 0.9},
                    Placed{"5 % and back after 15", 0.007, hill, 0.9},
                    Placed{"10 % in the last 5", 0.007, {{195, 1.1}}, 0.95}));

TEST(ChangePoints, Edges) {
  EXPECT_TRUE(change_points({}).empty());
  EXPECT_TRUE(change_points(std::vector<double>(7, 0.1)).empty());
  EXPECT_TRUE(change_points(std::vector<double>(120, 0.1)).empty());  // no spread at all
  std::vector<double> exact(60, 0.1);
  for (std::size_t i = 31; i < exact.size(); ++i) exact[i] = 0.2;
  const auto points = change_points(exact);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].index, 31U);
  EXPECT_NEAR(points[0].magnitude, 0.1, 1e-15);  // a mean of some dozen numbers
  exact[3] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(change_points(exact), std::invalid_argument);
}

// A step below the magnitude is none, however certain; one outlier is none, however large.
TEST(ChangePoints, IgnoresSmallStepsAndOutliers) {
  std::mt19937_64 random(59);
  EXPECT_TRUE(change_points(ratios(200, {{100, 1.015}}, 0.001, random)).empty());
  EXPECT_EQ(change_points(ratios(200, {{100, 1.015}}, 0.001, random), {.min_magnitude = 0.01}).size(), 1U);
  for (const std::size_t at : {1U, 60U, 198U, 199U}) {
    std::vector<double> series = ratios(200, {}, 0.005, random);
    series[at] += 0.5;
    EXPECT_TRUE(change_points(series).empty()) << at;
  }
}

// A history grows: a point that is found stays where it is when flat revisions follow.
TEST(ChangePoints, DoNotMoveWhenDataIsAdded) {
  std::mt19937_64 random(61);
  const std::vector<double> series = ratios(200, {{70, 1.05}}, 0.002, random);
  for (std::size_t size = 74; size <= series.size(); size += 6) {
    const auto points = change_points(std::span(series).first(size));
    ASSERT_EQ(points.size(), 1U) << size;
    EXPECT_EQ(points[0].index, 70U) << size;
  }
}

}  // namespace
}  // namespace cylon::statistics
