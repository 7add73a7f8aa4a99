#include "reports/comparison_report.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <map>

namespace cylon::reports {

using results::ComparedMetric;
using results::Comparison;
using results::ComparisonReport;
using results::Finding;

std::string changes(const Comparison& c) {
  std::string text = c.reason;
  const auto add = [&](const std::string& sentence) { text += (text.empty() ? "" : "; ") + sentence; };
  for (const ComparedMetric& metric : c.metrics)
    if (metric.finding != Finding::same) add(fmt::format("{}: {}", metric.name, metric.sentence));
  return text;
}

std::string brief(const Comparison& c) {
  if (!c.reason.empty()) return c.reason;
  const ComparedMetric* first = nullptr;
  int moved = 0;
  for (const ComparedMetric& metric : c.metrics) {
    if (metric.finding == Finding::same) continue;
    ++moved;
    if (!first || metric.finding < first->finding) first = &metric;
  }
  if (!first) return "";
  const std::string more = moved > 1 ? fmt::format(" (and {} more)", moved - 1) : "";
  return fmt::format("{}: {}{}", first->name, first->sentence, more);
}

std::string ratio(const Comparison& c) {
  if (!c.time) return c.untimed.empty() ? "-" : c.untimed;
  if (!std::isfinite(c.time->ratio)) return "-";
  return fmt::format("x {:.3f} ({:.3f} … {:.3f})", c.time->ratio, c.time->low, c.time->high);
}

std::string summary(const ComparisonReport& report) {
  std::map<Finding, int> counts;
  for (const Comparison& c : report.cells) ++counts[c.finding];
  std::string text;
  for (const auto& [finding, count] : counts)
    fmt::format_to(std::back_inserter(text), "{}{} {}", text.empty() ? "" : ", ", count,
                   results::name(finding));
  return text.empty() ? "nothing was compared" : text;
}

std::string warning(const ComparisonReport& report) {
  if (report.reliable || !report.self_check) return "";
  return fmt::format(
      "environment unreliable: the baseline differs from itself (x {:.3f}, {} pairs of {}), so the times of "
      "this run are ignored",
      report.self_check->ratio, report.self_check->pairs, report.self_check->what);
}

}  // namespace cylon::reports
