#include "harness/results/comparison.h"

#include <algorithm>

namespace cylon::results {

std::string_view name(Finding finding) {
  constexpr std::string_view names[] = {"regressed", "inconclusive", "improved",
                                        "changed",   "same",         "skipped"};
  return names[static_cast<int>(finding)];
}

Finding worst_finding(const Comparison& c) {
  Finding worst = c.finding;  // the enumerators stand in the order of their weight
  if (c.time) worst = std::min(worst, c.time->finding);
  for (const ComparedMetric& metric : c.metrics) worst = std::min(worst, metric.finding);
  return worst;
}

}  // namespace cylon::results
