// What counts as a change of a metric that repeats bit for bit: one run of each build is enough, and no p
// value is needed.  Time is judged by paired_rule.h.
#pragma once

#include "harness/tracking/statistics/outcome.h"

#include <array>
#include <string>
#include <string_view>

namespace cylon::statistics {

enum class MetricKind {
  exact,  ///< Hashes and counts: equal or not.
  error,  ///< A deviation from the truth: smaller is better.
  order,  ///< An observed order of convergence: larger is better.
  size,   ///< Memory, bytes of a binary: smaller is better.
  time,   ///< Noisy: the paired rule.
};

enum class Better { neither, smaller, larger };

/// A change counts where it exceeds `relative` times the magnitude before, `absolute`, and the floor that the
/// caller knows.
struct MetricRule {
  MetricKind kind;
  std::string_view name;
  double relative;
  double absolute;
  Better better;
  std::string_view says;     ///< The rule in words, for reports.
  std::string_view subject;  ///< Of a sentence: "count", "error", …
};

inline constexpr std::array<MetricRule, 5> metric_rules = {{
    {MetricKind::exact, "exact", 0, 0, Better::neither, "equal or not", "count"},
    {MetricKind::error, "error", 0.10, 0, Better::smaller, "by more than 10 % and the rounding floor",
     "error"},
    {MetricKind::order, "order", 0, 0.1, Better::larger, "by more than 0.1", "order"},
    {MetricKind::size, "size", 0.01, 0, Better::smaller, "by more than 1 %", "size"},
    {MetricKind::time, "time", 0.02, 0, Better::smaller, "by more than 2 %, confirmed by pairs of runs",
     "time"},
}};

/// The row of a kind; "exact", "error", "order", "size", "time".
const MetricRule& rule_of(MetricKind);

struct MetricResult {
  Outcome outcome = Outcome::same;  ///< regressed, improved, same or changed.
  std::string sentence;             ///< "error rose by 23 %, from 1e-06 to 1.23e-06".
};

/// Of two numbers by a kind's row.  `floor` is the rounding floor in the metric's own unit: differences up to
/// it are none.  A number that is not finite is worse than any that is, and the same as another such; where
/// there is no worse, any difference is a change.  Counts are exact up to 2^53.
MetricResult judge(MetricKind, double before, double after, double floor = 0);

/// Of two hashes.
MetricResult judge_hash(std::string_view before, std::string_view after);

}  // namespace cylon::statistics
