#include "harness/tracking/statistics/metric_rules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cylon::statistics {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
const double nan = std::numeric_limits<double>::quiet_NaN();

struct Row {
  MetricKind kind;
  double before, after, floor;
  Outcome outcome;
  const char* sentence;
};

class MetricRules : public testing::TestWithParam<Row> {};

TEST_P(MetricRules, Judge) {
  const Row& row = GetParam();
  const MetricResult result = judge(row.kind, row.before, row.after, row.floor);
  EXPECT_EQ(name(result.outcome), name(row.outcome)) << row.before << " -> " << row.after;
  EXPECT_EQ(result.sentence, row.sentence);
}

using enum MetricKind;
INSTANTIATE_TEST_SUITE_P(
    Rows, MetricRules,
    testing::Values(
        Row{exact, 812345678, 812345678, 0, Outcome::same, "count is equal"},
        Row{exact, 812345678, 812345679, 0, Outcome::changed,
            "count rose by 1.23e-07 %, from 812345678 to 812345679"},
        Row{exact, 12, 11, 0, Outcome::changed, "count fell by 8.33 %, from 12 to 11"},
        Row{exact, 12, nan, 0, Outcome::changed, "count is no longer finite, from 12 to nan"},
        // An accuracy fault of 20 %, and what lies on either side of 10 %.
        Row{error, 3.1e-6, 3.72e-6, 1e-15, Outcome::regressed,
            "error rose by 20 %, from 3.1e-06 to 3.72e-06"},
        Row{error, 3.1e-6, 3.38e-6, 1e-15, Outcome::same,
            "error rose by 9.03 %, from 3.1e-06 to 3.38e-06: within 10 %"},
        Row{error, 3.1e-6, 3.44e-6, 1e-15, Outcome::regressed,
            "error rose by 11 %, from 3.1e-06 to 3.44e-06"},
        Row{error, 3.1e-6, 2.5e-6, 1e-15, Outcome::improved, "error fell by 19.4 %, from 3.1e-06 to 2.5e-06"},
        // Twice the error, and all of it rounding.
        Row{error, 2.2e-16, 4.4e-16, 1e-15, Outcome::same,
            "error rose by 100 %, from 2.2e-16 to 4.4e-16: within the rounding floor 1e-15"},
        Row{error, 0, 2e-15, 1e-15, Outcome::regressed, "error rose, from 0 to 2e-15"},
        Row{error, 0, 5e-16, 1e-15, Outcome::same,
            "error rose, from 0 to 5e-16: within the rounding floor 1e-15"},
        Row{error, 1e-3, nan, 0, Outcome::regressed, "error is no longer finite, from 0.001 to nan"},
        Row{error, infinite, 1e-3, 0, Outcome::improved, "error became finite, from inf to 0.001"},
        Row{error, nan, infinite, 0, Outcome::same, "error is not finite in either"},
        Row{order, 4.02, 3.95, 0, Outcome::same, "order fell by 0.07, from 4.02 to 3.95: within 0.1"},
        Row{order, 4.02, 3.85, 0, Outcome::regressed, "order fell by 0.17, from 4.02 to 3.85"},
        Row{order, 1.98, 3.99, 0, Outcome::improved, "order rose by 2, from 1.98 to 3.99"},
        Row{size, 1000000, 1009000, 0, Outcome::same,
            "size rose by 0.9 %, from 1e+06 to 1.009e+06: within 1 %"},
        Row{size, 1000000, 1011000, 0, Outcome::regressed, "size rose by 1.1 %, from 1e+06 to 1.011e+06"},
        Row{size, 1000000, 900000, 0, Outcome::improved, "size fell by 10 %, from 1e+06 to 900000"}));

TEST(MetricRulesTable, JudgesHashesAndFindsRules) {
  EXPECT_EQ(judge_hash("8f3a", "8f3a").outcome, Outcome::same);
  EXPECT_EQ(judge_hash("8f3a", "8f3b").outcome, Outcome::changed);
  EXPECT_EQ(judge_hash("8f3a", "8f3b").sentence, "hash changed, from 8f3a to 8f3b");
  for (const MetricRule& rule : metric_rules) EXPECT_EQ(&rule_of(rule.kind), &rule);
}

// The better of two is worse the other way round, whatever the numbers (10 % up is 9.1 % down, so not near 10
// %).
TEST(MetricRulesTable, TwoWays) {
  for (const MetricKind kind : {error, order, size})
    for (const double factor : {0.3, 0.8, 0.999, 1.0, 1.001, 1.3, 4.0}) {
      const Outcome there = judge(kind, 2.0, 2.0 * factor).outcome,
                    back = judge(kind, 2.0 * factor, 2.0).outcome;
      EXPECT_EQ(there == Outcome::regressed, back == Outcome::improved) << name(there) << " " << factor;
      EXPECT_EQ(there == Outcome::same, back == Outcome::same) << factor;
    }
}

}  // namespace
}  // namespace cylon::statistics
