#include "harness/results/step_matrix.h"
#include "harness/study/cost.h"
#include "harness/study/sweep.h"

#include <algorithm>
#include <map>
#include <optional>

namespace cylon::study {

void sweep_times(results::TradeTable& table, const scenario::Scenario& scenario,
                 const std::vector<Setting>& settings, const SweepOptions& options, Memory& memory,
                 const SweepStep& done) {
  std::map<std::pair<std::size_t, std::size_t>, process::Repetition> best;
  for (int round = 0; round < options.rounds; ++round)
    for (std::size_t i = 0; i < table.series.size(); ++i) {
      const auto wanted = [&](std::size_t k) {
        return options.reach.empty() || std::ranges::any_of(options.reach, [&](double error) {
                 return results::coarsest_point(table, table.series[i], error) == k;
               });
      };
      for (std::size_t k = 0; k < table.series[i].points.size(); ++k) {
        results::TradePoint& point = table.series[i].points[k];
        if (point.status != results::Status::pass || !wanted(k)) continue;
        const Setting& setting = settings[i];
        std::optional<process::Repetition> time = memory.find_time(setting, point, round);
        if (!time) {
          Timed timed{setting.engine, {}, point.steps};
          timed.setup.dt = point.dt, timed.setup.tolerance = point.tolerance;
          timed.setup.integrator = setting.integrator_asked();
          const auto known = best.find({i, k});
          const double guess = known != best.end() ? known->second.step_seconds + known->second.load_seconds
                                                   : 1e-6 * static_cast<double>(point.steps * table.bodies);
          TimedOnce once = time_once(timed, scenario.scene, guess, options.limits);
          if (!once.least) {
            point.status = once.status, point.reason = std::move(once.reason);
            point.errors.clear();
            best.erase({i, k});
            continue;
          }
          time = once.least;
          memory.keep_time(setting, point, round, *time);
        }
        const auto [place, fresh] = best.try_emplace({i, k}, *time);
        if (!fresh) place->second = least(place->second, *time);
        if (done) done(setting, point, true);
      }
    }
  for (const auto& [where, time] : best) {
    results::TradeSeries& series = table.series[where.first];
    results::TradePoint& point = series.points[where.second];
    point.step_seconds = time.step_seconds, point.load_seconds = time.load_seconds;
    point.cost = cost(time, series.adaptive, table.duration);
  }
}

}  // namespace cylon::study
