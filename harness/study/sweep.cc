#include "harness/study/sweep.h"

#include "harness/core/input_error.h"
#include "harness/results/build.h"
#include "harness/results/duration.h"
#include "harness/study/order_fit.h"
#include "harness/study/parallel.h"
#include "harness/study/pareto.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

namespace cylon::study {
namespace {

using results::TradePoint;
using results::TradeSeries;

double epsilon(const std::string& precision) { return precision == "float" ? 0x1p-23 : 0x1p-52; }

double error_of(const TradePoint& point, std::size_t by) {
  return point.errors.empty() ? std::numeric_limits<double>::quiet_NaN() : point.errors[by];
}

// Whether a finer run can only repeat what is known.
bool is_over(const TradeSeries& series, std::size_t by) {
  const auto& points = series.points;
  if (points.back().status == results::Status::unsupported) return true;
  if (points.size() < 3) return false;
  const auto timed_out = [](const TradePoint& p) { return p.status == results::Status::timeout; };
  if (timed_out(points.back()) && timed_out(points[points.size() - 2])) return true;
  double best = HUGE_VAL;
  for (std::size_t i = 0; i + 2 < points.size(); ++i) best = std::fmin(best, error_of(points[i], by));
  const double low = series.precision == "float" ? 1e-3 : 1e-8;
  const auto no_better = [&](const TradePoint& p) { return error_of(p, by) > 0.8 * best; };
  return best < low && no_better(points.back()) && no_better(points[points.size() - 2]);
}

void describe(TradeSeries& series, const Ran& ran) {
  if (!ran.version.empty()) series.version = ran.version, series.precision = ran.precision;
  if (ran.order == 0) return;
  series.integrator = ran.integrator;
  series.path = ran.path, series.gyroscopic = ran.gyroscopic, series.declared = ran.order;
  series.closed_form = ran.closed_form, series.substeps = ran.substeps;
}

}  // namespace

std::optional<Ran> Memory::find(const Setting&, std::int64_t, double) { return std::nullopt; }
void Memory::keep(const Setting&, const Ran&) {}
std::optional<process::Repetition> Memory::find_time(const Setting&, const TradePoint&, int) {
  return std::nullopt;
}
void Memory::keep_time(const Setting&, const TradePoint&, int, const process::Repetition&) {}

std::string label(const TradeSeries& series) {
  return series.integrator.empty() ? series.engine : fmt::format("{} {}", series.engine, series.integrator);
}

Ran measure_run(const Setting& setting, const scenario::Scenario& scenario, const Yardstick& yardstick,
                std::int64_t steps, double tolerance, const process::Limits& limits) {
  process::RunRequest request = yardstick.request(steps);
  request.setup.integrator = setting.integrator_asked();
  request.setup.tolerance = tolerance;
  const process::RunOutcome outcome = process::run(setting.engine, request, limits);
  Ran ran;
  ran.integrator = outcome.terms.integrator;
  ran.version = outcome.engine.version, ran.precision = outcome.engine.precision;
  ran.path = outcome.terms.path, ran.gyroscopic = outcome.terms.gyroscopic;
  ran.order = outcome.terms.order;
  ran.closed_form = outcome.terms.closed_form, ran.substeps = outcome.terms.substeps;
  TradePoint& point = ran.point;
  point.steps = steps, point.dt = request.setup.dt, point.dt_text = step_text(scenario, steps);
  point.tolerance = tolerance;
  point.status = outcome.status, point.reason = outcome.reason;
  if (!outcome.recording) return ran;
  ran.cpu_seconds = outcome.recording->cpu_seconds;
  point.errors = yardstick.errors(*outcome.recording);
  if (std::any_of(point.errors.begin(), point.errors.end(), [](double e) { return !std::isfinite(e); })) {
    point.status = results::Status::non_finite;
    point.reason = "states or errors are NaN or infinite";
    point.errors.clear();
  }
  return ran;
}

results::TradeTable sweep_errors(const scenario::Scenario& scenario, const Yardstick& yardstick,
                                 const Ladder& ladder, std::vector<Setting>& settings,
                                 const SweepOptions& options, Memory& memory, const SweepStep& done) {
  results::TradeTable table;
  table.scenario = scenario.name, table.scenario_hash = scenario.hash;
  table.duration = scenario.duration;
  table.bodies = static_cast<std::int64_t>(scenario.scene.bodies.size());
  table.truth = yardstick.truth();
  table.samples = static_cast<std::size_t>(yardstick.samples());
  table.measures = yardstick.measures();
  table.by = options.by.value_or(yardstick.principal());
  table.series.resize(settings.size());
  std::vector<char> impossible(settings.size(), 0);
  // Samples of an integrator that controls its error: enough to show its path, at the steps of the ladder.
  constexpr std::int64_t enough = 1024;
  std::int64_t grid = ladder.samples;
  while (grid < enough && grid < ladder.steps.back()) grid *= 2;

  std::mutex reporting;
  in_parallel(settings.size(), options.workers, [&](std::size_t i) {
    const Setting& setting = settings[i];
    TradeSeries& series = table.series[i];
    series.engine = setting.engine.id, series.integrator = setting.integrator.name;
    series.adaptive = setting.integrator.adaptive;
    const std::size_t rungs = series.adaptive ? options.tolerances.size() : ladder.steps.size();
    for (std::size_t k = 0; k < rungs; ++k) {
      const std::int64_t steps = series.adaptive ? grid : ladder.steps[k];
      const double tolerance = series.adaptive ? options.tolerances[k] : 0;
      Ran ran;
      try {
        std::optional<Ran> known;
        {
          const std::scoped_lock lock(reporting);
          known = memory.find(setting, steps, tolerance);
        }
        ran = known ? *known : measure_run(setting, scenario, yardstick, steps, tolerance, options.limits);
        const std::scoped_lock lock(reporting);
        if (!known) memory.keep(setting, ran);
        if (done) done(setting, ran.point, false);
      } catch (const core::InputError&) {
        if (setting.asked) throw;
        impossible[i] = 1;
        return;
      }
      if (ran.path == "stepping" && !setting.first_fixed && !setting.asked) {
        impossible[i] = 1;
        return;
      }
      describe(series, ran);
      series.points.push_back(ran.point);
      if (is_over(series, table.by)) break;
    }
    if (std::all_of(series.points.begin(), series.points.end(),
                    [](const TradePoint& p) { return p.status == results::Status::unsupported; }) &&
        !series.points.empty()) {
      series.reason = series.points.front().reason;
      series.points.clear();
    }
    if (series.adaptive) return;
    std::vector<StepError> errors;
    for (const TradePoint& point : series.points) errors.push_back({point.dt, error_of(point, table.by)});
    const OrderFit fit =
        fit_order(errors, 3 * table.measures[table.by].resolution, epsilon(series.precision));
    if (fit.order) series.order = *fit.order;
    if (!fit.floor) return;
    series.floor = *fit.floor, series.floor_from = fit.floor_from, series.rounding = fit.rounding;
  });
  for (std::size_t i = settings.size(); i-- > 0;)
    if (impossible[i]) {
      table.series.erase(table.series.begin() + static_cast<std::ptrdiff_t>(i));
      settings.erase(settings.begin() + static_cast<std::ptrdiff_t>(i));
    }
  return table;
}

namespace {

// Of the series of one build.
void mark_front_of(const std::vector<TradeSeries*>& list, std::size_t by) {
  std::vector<Tradeoff> points;
  std::vector<std::pair<TradeSeries*, TradePoint*>> where;
  for (TradeSeries* series : list)
    for (TradePoint& point : series->points) {
      const double error = error_of(point, by);
      points.push_back({point.cost, error < 1 ? error : HUGE_VAL});  // a motion that is lost is worth nothing
      where.emplace_back(series, &point);
    }
  const std::vector<Standing> standing = pareto(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    where[i].second->on_front = standing[i].on_front;
    where[i].second->dominated_by.clear();
    if (!standing[i].by) continue;
    const auto& [series, point] = where[*standing[i].by];
    where[i].second->dominated_by =
        series->adaptive ? fmt::format("{} at {:.0e}", label(*series), point->tolerance)
                         : fmt::format("{} at {}", label(*series), results::step_in_words(point->dt_text));
  }
}

}  // namespace

void mark_front(results::TradeTable& table) {
  std::map<std::string, std::vector<TradeSeries*>> builds;
  for (TradeSeries& series : table.series) builds[results::build_of(series.version)].push_back(&series);
  for (const auto& [build, series] : builds) mark_front_of(series, table.by);
}

}  // namespace cylon::study
