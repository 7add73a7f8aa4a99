#include "harness/results/step_matrix.h"

#include "harness/results/duration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace cylon::results {
namespace {

double error_of(const TradeTable& table, const TradePoint& point) {
  return point.errors.empty() ? std::numeric_limits<double>::quiet_NaN() : point.errors[table.by];
}

// The point of the least error; nullptr: none is finite.
const TradePoint* best_point(const TradeTable& table, const TradeSeries& series) {
  const TradePoint* best = nullptr;
  for (const TradePoint& point : series.points)
    if (std::isfinite(error_of(table, point)) && (!best || error_of(table, point) < error_of(table, *best)))
      best = &point;
  return best;
}

// One error has no slope: that no order was fitted says nothing of the engine then.
bool has_too_few_steps(const TradeSeries& series) { return !series.adaptive && series.points.size() == 1; }

bool runs(const TradeSeries& series) { return !series.points.empty(); }

// A tolerance says nothing where the engine goes by fixed steps.
bool is_moot(const TradeSeries& series) { return series.adaptive && series.path == "stepping"; }

std::size_t series_of(const TradeTable& table, const std::string& engine) {
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < table.series.size(); ++i) {
    const TradeSeries& series = table.series[i];
    if (series.engine != engine) continue;
    if (runs(series) && !is_moot(series)) return i;
    if (!first) first = i;
  }
  return first.value();
}

}  // namespace

std::optional<std::size_t> coarsest_point(const TradeTable& table, const TradeSeries& series, double error) {
  const auto meets = [&](std::size_t i) { return error_of(table, series.points[i]) <= error; };
  for (std::size_t i = 0; i < series.points.size(); ++i)
    if (meets(i) && (i + 1 == series.points.size() || meets(i + 1))) return i;
  return std::nullopt;
}

std::string why_not_reached(const TradeTable& table, const TradeSeries& series, double error) {
  if (!runs(series)) return series.reason;
  const TradePoint* best = best_point(table, series);
  if (!best)
    return fmt::format("no run ends: {}{}{}", name(series.points.back().status),
                       series.points.back().reason.empty() ? "" : ", ", series.points.back().reason);
  const double least = error_of(table, *best);
  if (series.adaptive) return fmt::format("error {:.1g} at tolerance {:.0e}", least, best->tolerance);
  if (series.points.back().status == Status::timeout)
    return fmt::format("error {:.1g} at {}, time limit exceeded below", least, duration(best->dt, 2));
  if (std::isfinite(series.floor) && series.floor > error)
    return fmt::format("stays at {:.1g} below {}{}", series.floor, duration(series.floor_from, 2),
                       series.rounding ? fmt::format(": rounding in {} precision",
                                                     series.precision == "float" ? "single" : "double")
                                       : "");
  if (least <= error) return "met at single steps only: the error scatters";
  // An error of a third of the motion obeys no law of small errors.
  if (least > 0.3) return fmt::format("never near: error {:.1g} at {}", least, duration(best->dt, 2));
  if (has_too_few_steps(series))
    return fmt::format("error {:.1g} at {}, too few steps tried for an order", least, duration(best->dt, 2));
  if (!(series.order >= 0.5))
    return fmt::format("error {:.1g} at {}, falls with no order", least, duration(best->dt, 2));
  // e = C dt^p
  const double needed = best->dt * std::pow(error / least, 1 / series.order);
  return fmt::format("needs about {} at this order", duration(needed, 2));
}

std::vector<StepCell> step_cells(const TradeTable& table) {
  std::vector<StepCell> cells;
  std::set<std::string> seen;
  for (const TradeSeries& any : table.series) {
    if (!seen.insert(any.engine).second) continue;
    StepCell cell;
    cell.series = series_of(table, any.engine);
    const TradeSeries& series = table.series[cell.series];
    if (!runs(series)) cell.refusal = series.reason;
    for (const double error : reach_errors) {
      Reach reach{.error = error};
      reach.point = coarsest_point(table, series, error);
      reach.coarsest_tried = reach.point == std::size_t{0};
      if (!reach.point) reach.why = why_not_reached(table, series, error);
      if (!reach.point && runs(series) && !series.cause.empty() && !has_too_few_steps(series))
        reach.why += fmt::format("; cause: {}", series.cause);
      cell.reach.push_back(std::move(reach));
    }
    cells.push_back(std::move(cell));
  }
  for (StepCell& cell : cells) {
    if (cell.refusal.empty()) continue;
    for (const StepCell& other : cells)
      if (std::ranges::any_of(other.reach, [](const Reach& reach) { return reach.point.has_value(); }))
        cell.avoidable += (cell.avoidable.empty() ? "" : ", ") + table.series[other.series].engine;
  }
  return cells;
}

std::optional<DigitsAt> digits_at(const TradeTable& table, const TradeSeries& series, double dt) {
  for (std::size_t i = 0; i < series.points.size(); ++i) {
    const TradePoint& point = series.points[i];
    // Steps are near to dt, as a duration allows that they divide: 1.0016 ms is a step of 1 ms, and half of it is none.
    if (!series.adaptive && point.dt > 1.02 * dt) continue;
    const double error = error_of(table, point);
    if (!std::isfinite(error)) return std::nullopt;
    return DigitsAt{i, std::min(16.0, -std::log10(std::max(error, 1e-16)))};
  }
  return std::nullopt;
}

}  // namespace cylon::results
