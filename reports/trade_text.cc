#include "harness/results/build.h"
#include "harness/results/duration.h"
#include "reports/text.h"
#include "reports/trade_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

namespace cylon::reports {
namespace {

using results::TradePoint;
using results::TradeSeries;
using results::TradeTable;

std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.1e}", value) : "-"; }

// The errors at which a line says the cost.
std::vector<double> marks(const TradeTable& table) {
  std::vector<double> result = {1e-2, 1e-4, 1e-6};
  if (table.target > 0 && std::find(result.begin(), result.end(), table.target) == result.end())
    result.push_back(table.target);
  std::sort(result.rbegin(), result.rend());
  return result;
}

std::string head(const TradeTable& table, const ConsoleOptions& options) {
  const results::TradeMeasure& by = table.measures[table.by];
  std::string text = fmt::format("{}: {} s, {} bod{}\n", shown(table.scenario, options), table.duration,
                                 table.bodies, table.bodies == 1 ? "y" : "ies");
  if (table.truth.empty())
    text += fmt::format("  no exact solution is known: settings are compared by {} only\n", by.name);
  return text + fmt::format("  error: {} against {}, relative, the largest of {} times; known to {:.0e}\n",
                            by.name, shown(by.against, options), table.samples,
                            std::max(by.resolution, 1e-16));
}

std::string points(const TradeTable& table, const TradeSeries& series, const ConsoleOptions& options) {
  std::string text;
  for (const TradePoint& p : series.points) {
    std::string line = fmt::format(
        "  {} {:<14}", p.on_front ? '*' : ' ',
        p.tolerance > 0 ? fmt::format("tol {:.0e}", p.tolerance) : results::step_in_words(p.dt_text));
    if (p.errors.empty())
      line += fmt::format("{}: {}", results::name(p.status), p.reason);
    else
      for (const double e : p.errors) line += fmt::format(" {:>11}", number(e));
    if (!p.errors.empty())
      line += fmt::format(" {:>9} {:>8} {:>9}  {}", number(p.cost),
                          number(1e9 * p.step_seconds /
                                 static_cast<double>(p.steps * std::max<std::int64_t>(1, table.bodies))),
                          number(p.load_seconds), p.dominated_by.empty() ? "" : "< " + p.dominated_by);
    text += fitted(shown(line, options), std::max(options.width, 100), options.utf8 ? "…" : "...");
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

using Front = std::vector<std::pair<const TradeSeries*, const TradePoint*>>;

std::string front_text(const TradeTable& table, const std::string& build, Front front, int name_width,
                       const ConsoleOptions& options) {
  std::stable_sort(front.begin(), front.end(),
                   [](const auto& a, const auto& b) { return a.second->cost < b.second->cost; });
  std::string out =
      build.empty()
          ? "\nPareto front (*): no other setting is both faster and more accurate:\n"
          : fmt::format("\nPareto front (*) of {}: none of these is both faster and more accurate:\n",
                        shown(build, options));
  for (const auto& [series, point] : front)
    out += fmt::format(
        "* {} {:<16} error {:>8}  CPU {:>8} s/s  {:>8} ns/body-step\n",
        fitted(shown(trade_label(table, *series), options), name_width, options.utf8 ? "…" : "..."),
        point->tolerance > 0 ? fmt::format("tol {:.0e}", point->tolerance)
                             : shown(results::step_in_words(point->dt_text), options),
        number(point->errors[table.by]), number(point->cost),
        number(1e9 * point->step_seconds /
               static_cast<double>(point->steps * std::max<std::int64_t>(1, table.bodies))));
  return out;
}

}  // namespace

std::string trade_text(const TradeTable& table, const ConsoleOptions& options, bool every_point) {
  const auto safe = [&](const std::string& text) { return shown(text, options); };
  const std::string dots = options.utf8 ? "…" : "...";
  if (table.measures.empty())
    return safe(fmt::format("{}: nothing to measure: no exact solution and no conserved quantity",
                            table.scenario)) +
           '\n';
  std::string out = head(table, options);
  const std::vector<double> errors = marks(table);
  // Names first, which tell the rows apart; then what was observed.
  const int width = std::clamp(options.width, 100, 130) - 1 - 4 - 9 * static_cast<int>(errors.size());
  constexpr int least_name = 30, least_room = 29;
  int name_width = least_name;
  for (const TradeSeries& series : table.series)
    name_width = std::max(name_width, display_width(safe(trade_label(table, series))));
  name_width = std::clamp(width - least_room, least_name, name_width);
  const int room = std::max(least_room, width - name_width);
  out += fmt::format("\n{:<{}} {:>3} {:<{}}", "", name_width, "p", "observed", room);
  for (const double e : errors) out += fmt::format(" {:>8}", fmt::format("@{:.0e}", e));
  out += '\n';
  for (const TradeSeries& series : table.series) {
    std::string line = fmt::format("{} {:>3} ", fitted(safe(trade_label(table, series)), name_width, dots),
                                   series.adaptive       ? "tol"
                                   : series.declared > 0 ? std::to_string(series.declared)
                                                         : "-");
    line += fitted(safe(order_text(table, series)), room, dots);
    for (const double e : errors) {
      const TradePoint* best = cheapest(table, series, e);
      line += fmt::format(" {:>8}", best ? number(best->cost) : "-");
    }
    out += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    if (every_point) {
      std::string names = fmt::format("    {:<14}", series.adaptive ? "tolerance" : "step");
      for (const results::TradeMeasure& m : table.measures)
        names += fmt::format(" {:>11}", m.name.substr(0, 11));
      out += names + fmt::format(" {:>9} {:>8} {:>9}\n", "CPU s/s", "ns/b-st", "load s");
      out += points(table, series, options);
    }
  }
  out +=
      "\n"
      "p: order that the engine declares. @: CPU seconds per simulated second to reach this error.\n";
  out += substeps_of({table}, options) + costs_of_another_build({table}, options);

  std::map<std::string, Front> fronts;  // by build; that of native code first
  for (const TradeSeries& series : table.series)
    for (const TradePoint& point : series.points)
      if (point.on_front) fronts[results::build_of(series.version)].emplace_back(&series, &point);
  for (const auto& [build, front] : fronts) out += front_text(table, build, front, name_width, options);
  return out;
}

}  // namespace cylon::reports
