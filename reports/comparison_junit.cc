#include "reports/comparison_report.h"
#include "reports/xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace cylon::reports {
namespace {

using results::Comparison;
using results::ComparisonReport;
using results::Finding;

std::string sentence(const Comparison& c) {
  std::string text = fmt::format("time {}", ratio(c));
  if (c.time)
    text += fmt::format(", {}, {} pairs of {}", results::name(c.time->finding), c.time->pairs, c.time->what);
  const std::string changed = changes(c);
  return changed.empty() ? text : text + "; " + changed;
}

std::string element(const Comparison& c, const std::string& unreliable) {
  const std::string reason = xml(sentence(c));
  switch (c.finding) {
    case Finding::regressed:
      return fmt::format("<failure type=\"regressed\" message=\"{0}\">{0}\n{1}</failure>", reason,
                         xml(c.reproduce));
    case Finding::skipped:
      return fmt::format("<skipped message=\"{0}\">{0}</skipped>", xml(c.reason));
    case Finding::inconclusive:
      return fmt::format("<skipped message=\"inconclusive: {0}\">{0}</skipped>",
                         unreliable.empty() ? reason : xml(unreliable));
    case Finding::improved:
    case Finding::changed:
    case Finding::same:
      break;
  }
  return fmt::format("<system-out>{}: {}</system-out>", results::name(c.finding), reason);
}

using Cells = std::vector<const Comparison*>;

std::string counts(const Cells& cells) {
  const auto of = [&](Finding f) {
    return std::count_if(cells.begin(), cells.end(), [&](const Comparison* c) { return c->finding == f; });
  };
  return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\"", cells.size(),
                     of(Finding::regressed), of(Finding::skipped) + of(Finding::inconclusive));
}

}  // namespace

std::string to_junit(const ComparisonReport& report) {
  Cells all;
  std::vector<std::pair<std::string, Cells>> suites;  // in order of first appearance
  for (const Comparison& c : report.cells) {
    all.push_back(&c);
    auto suite =
        std::find_if(suites.begin(), suites.end(), [&](const auto& s) { return s.first == c.scenario; });
    if (suite == suites.end()) suite = suites.insert(suites.end(), {c.scenario, {}});
    suite->second.push_back(&c);
  }
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  out += fmt::format("<testsuites name=\"cylon track\" {}>\n", counts(all));
  const std::string unreliable = warning(report);
  for (const auto& [scenario, cells] : suites) {
    out += fmt::format("  <testsuite name=\"{}\" {}>\n", xml(scenario), counts(cells));
    for (const Comparison* c : cells)
      out += fmt::format(
          "    <testcase classname=\"{}.{}\" name=\"against {} [dt {}]\" time=\"{:.6f}\">{}</testcase>\n",
          xml(c->scenario), xml(c->engine), xml(report.baseline), xml(c->dt_text),
          c->time ? c->time->candidate_seconds : 0.0, element(*c, unreliable));
    out += "  </testsuite>\n";
  }
  return out + "</testsuites>\n";
}

}  // namespace cylon::reports
