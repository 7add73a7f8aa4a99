#include "reports/step_matrix.h"

#include "harness/results/duration.h"
#include "reports/text.h"
#include "reports/trade_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace cylon::reports {
namespace {

using results::Reach;
using results::StepCell;
using results::TradePoint;
using results::TradeSeries;
using results::TradeTable;

constexpr int step_width = 9, cost_width = 8;

// "1e-2"
std::string power(double error) { return fmt::format("1e{:.0f}", std::log10(error)); }

// Steps divide a duration, 20/20032 s in place of 1 ms, and times scatter: two digits.
std::string seconds(double value, const ConsoleOptions& options) {
  return shown(results::duration(value, 2), options);
}

std::string step_of(const TradeSeries& series, const Reach& reach, const ConsoleOptions& options) {
  const TradePoint& point = series.points[*reach.point];
  if (series.closed_form) return "no steps";
  if (series.adaptive) return fmt::format("tol {}", power(point.tolerance));
  const char* more = reach.coarsest_tried ? options.utf8 ? "≥ " : ">=" : "";
  return more + seconds(point.dt, options);
}

std::string line_of(const TradeTable& table, const StepCell& cell, int names, const ConsoleOptions& options) {
  const std::string_view dots = options.utf8 ? "…" : "...";
  const TradeSeries& series = table.series[cell.series];
  std::string line = "  " + fitted(shown(series.engine, options), names, dots) + "  ";
  if (!cell.refusal.empty())
    return line + shown(cell.avoidable.empty()
                            ? fmt::format("refused: {}", cell.refusal)
                            : fmt::format("refused, though {} can: {}", cell.avoidable, cell.refusal),
                        options);
  std::string why;
  for (const Reach& reach : cell.reach) {
    if (reach.point) {
      line += fitted(step_of(series, reach, options), step_width, dots) + " " +
              fitted(seconds(series.points[*reach.point].cost, options), cost_width, dots);
    } else {
      line += fitted("not reached", step_width + 1 + cost_width, dots);
      if (why.empty()) why = fmt::format("{}: {}", power(reach.error), reach.why);
    }
    line += "  ";
  }
  const bool has_order = !series.adaptive && std::isfinite(series.order);
  line += fitted(has_order ? fmt::format("{:.2f}", series.order) : "-", 5, dots);
  return line + "  " + shown(why, options);
}

int widest(const TradeTable& table, const std::vector<StepCell>& cells) {
  int width = 0;
  for (const StepCell& cell : cells) width = std::max(width, display_width(table.series[cell.series].engine));
  return std::min(width, 32);
}

std::string trimmed(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

}  // namespace

std::string steps_text(const std::vector<TradeTable>& tables, const ConsoleOptions& options) {
  std::string out;
  bool closed = false, tolerance = false, bound = false;
  int names = 0;
  for (const TradeTable& table : tables) names = std::max(names, widest(table, step_cells(table)));
  for (const TradeTable& table : tables) {
    if (!out.empty()) out += '\n';
    if (table.measures.empty()) {
      out += shown(table.scenario, options) +
             ": nothing to measure: no exact solution and no conserved quantity\n";
      continue;
    }
    const results::TradeMeasure& by = table.measures[table.by];
    out += shown(fmt::format("{}: {} s, {}; error of {} against {}", table.scenario, table.duration,
                             counted(static_cast<std::size_t>(table.bodies), "body", "bodies"), by.name,
                             by.against),
                 options) +
           '\n';
    std::string head(static_cast<std::size_t>(names) + 4, ' ');
    for (const double error : results::reach_errors)
      head += fitted("error " + power(error), step_width + 1 + cost_width, "") + "  ";
    out += head + "order\n";
    for (const StepCell& cell : step_cells(table)) {
      const TradeSeries& series = table.series[cell.series];
      for (const Reach& reach : cell.reach) {
        if (!reach.point) continue;
        closed |= series.closed_form;
        tolerance |= series.adaptive && !series.closed_form;
        bound |= !series.adaptive && reach.coarsest_tried;
      }
      out += trimmed(line_of(table, cell, names, options));
    }
  }
  out +=
      "\nThe coarsest step that meets the error, as the next finer one does, and CPU time per simulated "
      "second.\n";
  if (bound) out += options.utf8 ? "≥: no coarser step was tried.\n" : ">=: no coarser step was tried.\n";
  if (closed) out += "no steps: the engine has the motion in closed form; a step says nothing of it.\n";
  if (tolerance) out += "tol: the integrator chooses its steps; this is the loosest tolerance that serves.\n";
  return out + substeps_of(tables, options) + costs_of_another_build(tables, options);
}

std::string digits_text(const std::vector<TradeTable>& tables, double dt, const ConsoleOptions& options) {
  const std::string_view dots = options.utf8 ? "…" : "...";
  std::vector<std::string> engines;
  for (const TradeTable& table : tables)
    for (const StepCell& cell : step_cells(table))
      if (std::ranges::find(engines, table.series[cell.series].engine) == engines.end())
        engines.push_back(table.series[cell.series].engine);
  int first = 8;
  for (const TradeTable& table : tables)
    first = std::max(first, display_width(shown(table.scenario, options)));
  std::string out = fitted("scenario", first, dots) + "  " + fitted("step", step_width, dots);
  std::vector<int> widths;
  for (const std::string& engine : engines) {
    widths.push_back(std::max(11, display_width(shown(engine, options))));
    out += "  " + fitted(shown(engine, options), widths.back(), dots);
  }
  out = trimmed(out);
  for (const TradeTable& table : tables) {
    std::map<std::string, std::string> texts;
    std::string step = "-";
    for (const StepCell& cell : step_cells(table)) {
      const TradeSeries& series = table.series[cell.series];
      const auto at = digits_at(table, series, dt);
      std::string& text = texts[series.engine];
      if (!cell.refusal.empty())
        text = "refused";
      else if (series.closed_form)
        text = "closed form";
      else if (series.adaptive)
        text = "own steps";
      else
        text = at ? fmt::format("{:.1f}", at->digits) : "-";
      if (at && !series.adaptive) step = seconds(series.points[at->point].dt, options);
    }
    std::string line =
        fitted(shown(table.scenario, options), first, dots) + "  " + fitted(step, step_width, dots);
    for (std::size_t i = 0; i < engines.size(); ++i)
      line += "  " + fitted(texts.contains(engines[i]) ? texts[engines[i]] : "", widths[i], dots);
    out += trimmed(line);
  }
  return out +
         fmt::format(
             "\nDigits: -log10 of the relative error at the coarsest tried step of at most {}; -: no run at "
             "such a step.\n",
             seconds(dt, options)) +
         substeps_of(tables, options);
}

nlohmann::ordered_json steps_json(const TradeTable& table) {
  using Json = nlohmann::ordered_json;
  Json cells = Json::array();
  if (table.measures.empty()) return cells;
  for (const StepCell& cell : step_cells(table)) {
    Json reach = Json::array();
    for (const Reach& one : cell.reach)
      reach.push_back({{"error", one.error},
                       {"point", one.point ? Json(*one.point) : Json(nullptr)},
                       {"coarsest_tried", one.coarsest_tried},
                       {"why", one.why}});
    cells.push_back({{"series", cell.series},
                     {"refusal", cell.refusal},
                     {"avoidable", cell.avoidable},
                     {"reach", std::move(reach)}});
  }
  return cells;
}

}  // namespace cylon::reports
