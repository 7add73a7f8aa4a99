// Common parts of the three renderings of a work–precision table: names, order texts, the plot.
#include "harness/results/build.h"
#include "harness/results/duration.h"
#include "harness/results/substeps.h"
#include "reports/builds.h"
#include "reports/text.h"
#include "reports/trade_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace cylon::reports {
namespace {

using results::TradePoint;
using results::TradeSeries;
using results::TradeTable;

double error_of(const TradeTable& table, const TradePoint& point) {
  return point.errors.empty() ? std::nan("") : point.errors[table.by];
}

std::string place(const TradePoint& point) {
  return point.tolerance > 0 ? fmt::format("tolerance {:.0e}", point.tolerance)
                             : results::step_in_words(point.dt_text);
}

std::string engine_family(const std::string& engine) { return engine.substr(0, engine.find('/')); }

}  // namespace

std::string trade_label(const TradeTable& table, const TradeSeries& series) {
  const auto same = std::count_if(table.series.begin(), table.series.end(),
                                  [&](const TradeSeries& s) { return s.engine == series.engine; });
  // A variant that states nothing but the integrator reads like any other series.
  const std::string stated = "/integrator=" + series.integrator;
  if (!series.integrator.empty() && series.engine.ends_with(stated))
    return fmt::format("{} {}", series.engine.substr(0, series.engine.size() - stated.size()),
                       series.integrator);
  return same == 1 || series.integrator.empty() ? series.engine
                                                : fmt::format("{} {}", series.engine, series.integrator);
}

std::string costs_of_another_build(const std::vector<TradeTable>& tables, const ConsoleOptions& options) {
  std::map<std::string, std::string> versions;
  for (const TradeTable& table : tables)
    for (const TradeSeries& series : table.series) versions[series.engine] = series.version;
  return costs_of_another_build(versions, options);
}

std::string substeps_of(const std::vector<TradeTable>& tables, const ConsoleOptions& options) {
  std::map<std::string, int> most;
  for (const TradeTable& table : tables)
    for (const TradeSeries& series : table.series)
      if (series.substeps > 1) most[series.engine] = std::max(most[series.engine], series.substeps);
  std::string text;
  for (const auto& [engine, substeps] : most)
    text +=
        shown(fmt::format("{}: {} in each step.", engine, results::with_substeps("", substeps)), options) +
        '\n';
  return text;
}

const TradePoint* cheapest(const TradeTable& table, const TradeSeries& series, double error) {
  const TradePoint* best = nullptr;
  const auto work = [](const TradePoint& p) {
    return std::isfinite(p.cost) ? p.cost : static_cast<double>(p.steps);
  };
  for (const TradePoint& point : series.points)
    if (error_of(table, point) <= error && (!best || work(point) < work(*best))) best = &point;
  return best;
}

std::string order_text(const TradeTable& table, const TradeSeries& series) {
  const TradePoint* best = nullptr;
  for (const TradePoint& point : series.points)
    if (std::isfinite(error_of(table, point)) && (!best || error_of(table, point) < error_of(table, *best)))
      best = &point;
  if (!best) {
    if (series.points.empty()) return series.reason;
    return fmt::format("no finite run: {}", results::name(series.points.back().status));
  }
  const std::string reached = fmt::format("best {:.0e} at {}", error_of(table, *best), place(*best));
  if (series.adaptive) return reached;
  if (std::isfinite(series.floor)) {
    const auto from = std::find_if(series.points.begin(), series.points.end(),
                                   [&](const TradePoint& p) { return p.dt == series.floor_from; });
    const std::string floor =
        fmt::format("{} {:.0e} from {}", series.rounding ? "floor" : "stalls at", series.floor,
                    from == series.points.end() ? results::duration(series.floor_from) : place(*from));
    return std::isfinite(series.order) ? fmt::format("{:.2f}, {}", series.order, floor) : floor;
  }
  const double least = error_of(table, *best);
  if (!std::isfinite(series.order) || (series.order < 0.5 && least > 0.01))
    return fmt::format("{}, {}",
                       least > 0.01   ? "never near"
                       : least < 1e-7 ? "rounding"
                                      : "no order",
                       reached);
  return fmt::format("{:.2f}, {}", series.order, reached);
}

Plot trade_plot(const TradeTable& table) {
  Plot plot;
  bool timed = false;
  for (const TradeSeries& series : table.series)
    for (const TradePoint& point : series.points) timed |= std::isfinite(point.cost);
  plot.title = fmt::format("{}: error against cost", table.scenario);
  plot.x_label = timed ? "CPU seconds per simulated second" : "steps per simulated second";
  plot.y_label =
      fmt::format("relative error ({}), largest over {} s", table.measures[table.by].name, table.duration);
  plot.line = table.target;
  std::map<std::string, int> colours, markers;
  std::map<std::string, std::vector<std::pair<double, double>>> fronts;  // by build
  for (const TradeSeries& series : table.series) {
    if (series.points.empty()) continue;
    const std::string family = engine_family(series.engine);
    Curve curve;
    curve.name = trade_label(table, series);
    curve.colour = colours.try_emplace(family, static_cast<int>(colours.size())).first->second;
    curve.marker = markers[family]++;
    for (const TradePoint& point : series.points) {
      const double x = timed ? point.cost : static_cast<double>(point.steps) / table.duration;
      // An error of nothing is drawn at the last bit of a double.
      curve.points.emplace_back(x, std::max(error_of(table, point), 0x1p-53));
      if (point.on_front) fronts[results::build_of(series.version)].push_back(curve.points.back());
    }
    plot.curves.push_back(std::move(curve));
  }
  for (auto& [build, front] : fronts) {
    std::sort(front.begin(), front.end());
    plot.fronts.push_back(std::move(front));
  }
  return plot;
}

}  // namespace cylon::reports
