#include "harness/study/advise.h"

#include "harness/core/input_error.h"
#include "harness/core/worst.h"
#include "harness/results/duration.h"
#include "harness/study/coarsest.h"
#include "harness/study/cost.h"
#include "harness/study/ladder.h"
#include "harness/study/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

namespace cylon::study {
namespace {

using results::EngineAdvice;
using results::Pick;

// The settings of an integrator from coarse to fine: steps, or tolerances on a fixed grid.
struct Row {
  std::vector<std::int64_t> steps;
  std::vector<double> tolerances;  // 0: none
  double digits = 0;               // by which each lowers the error

  std::size_t size() const { return steps.size(); }
};

Row row_of(const core::Integrator& integrator, std::int64_t samples, std::int64_t most) {
  Row row;
  if (integrator.adaptive) {
    std::int64_t grid = samples;
    while (grid < 1024 && 2 * grid <= most) grid *= 2;
    for (int half = 1; half <= 26; ++half) {
      row.steps.push_back(grid);
      row.tolerances.push_back(std::pow(10, -0.5 * half));
    }
    row.digits = 0.5;
    return row;
  }
  row.steps = fine_steps(samples, most);
  row.tolerances.assign(row.steps.size(), 0);
  row.digits = 0.25 * std::log10(2.0) * std::max(1, integrator.order);
  return row;
}

// What was found for one integrator.
struct Found {
  std::optional<Pick> pick, ten_times, best;
  double cpu = HUGE_VAL, ten_cpu = HUGE_VAL;  // of the recorded runs: a first guess of costs
  std::string version, reason;
};

// The engine is there and says that it cannot run this.
struct Cannot {
  std::string reason;
};

class Search {
 public:
  Search(const std::vector<Start>& starts, const Setting& setting, const AdviseOptions& options)
      : starts_(starts),
        setting_(setting),
        options_(options),
        row_(row_of(setting.integrator, starts.front().yardstick->samples(),
                    options.most / static_cast<std::int64_t>(starts.front().scenario->scene.bodies.size()))) {
  }

  Found find() {
    Found found = search();
    found.version = version_;
    return found;
  }

 private:
  Found search() {
    Found found;
    if (row_.size() == 0) return found;
    const double target = options_.tolerance;
    const auto error_at = [&](std::size_t i) { return error(0, i); };
    // Where the nominal step lies, or the tolerance itself.
    std::size_t guess = 0;
    const std::int64_t nominal = nominal_steps(*starts_.front().scenario);
    while (guess + 1 < row_.size() &&
           (setting_.integrator.adaptive ? row_.tolerances[guess] > target : row_.steps[guess] < nominal))
      ++guess;
    if (!setting_.integrator.adaptive && setting_.integrator.order > 1) guess /= 2;
    std::map<std::size_t, double> seen;
    const Coarsest first = coarsest(error_at, row_.size(), target / margin, row_.digits, guess, seen);
    if (std::isfinite(first.best_error)) found.best = pick(first.best, first.best_error);
    if (first.pick) {
      const Checked checked = check(*first.pick);
      if (checked.holds) found.cpu = cpu_[checked.setting];
      if (std::isfinite(checked.worst))
        (checked.holds ? found.pick : found.best) = pick(checked.setting, checked.worst);
    }
    if (found.pick) {
      const Coarsest ten = coarsest(error_at, row_.size(), target / 10, row_.digits, *first.pick, seen);
      if (ten.pick) found.ten_times = pick(*ten.pick, ten.error), found.ten_cpu = cpu_[*ten.pick];
      for (const auto& [i, e] : seen)
        if (e < found.best->error) found.best = pick(i, e);
    }
    return found;
  }

  double error(std::size_t start, std::size_t i) {
    const Start& from = starts_[start];
    const Ran ran = measure_run(setting_, *from.scenario, *from.yardstick, row_.steps[i], row_.tolerances[i],
                                options_.limits);
    version_ = ran.version, substeps_ = ran.substeps;
    if (ran.path == "stepping" && !setting_.first_fixed && !setting_.asked)
      throw Cannot{"this path does not use this integrator"};
    if (ran.point.status == results::Status::unsupported) throw Cannot{ran.point.reason};
    if (start == 0) cpu_[i] = ran.cpu_seconds;
    return ran.point.errors.empty() ? std::nan("") : ran.point.errors[from.by];
  }

  struct Checked {
    bool holds = false;
    std::size_t setting = 0;
    double worst = HUGE_VAL;  // of its errors, up to the first that is too large
  };

  // The first setting from `i` on that serves from every start; else the one that came nearest.
  Checked check(std::size_t i) {
    const double target = options_.tolerance / margin;
    Checked nearest{false, i};
    for (std::size_t further = 1; i < row_.size(); i += further) {
      double worst = 0;
      for (std::size_t s = 0; s < starts_.size() && worst <= target; ++s)
        worst = core::worst(error(s, i), worst);
      if (worst <= target) return {true, i, worst};
      if (worst < nearest.worst) nearest.setting = i, nearest.worst = worst;
      // By the law, and one at least; no leap where it is a near miss.
      const double missing = !std::isfinite(worst) ? 1 : worst > 2 * target ? std::log10(worst / target) : 0;
      further = std::clamp<std::size_t>(static_cast<std::size_t>(missing / row_.digits), 1, 8);
    }
    return nearest;
  }

  Pick pick(std::size_t i, double error) const {
    Pick p;
    p.engine = setting_.engine.id, p.integrator = setting_.integrator.name;
    p.substeps = substeps_;
    p.steps = row_.steps[i], p.tolerance = row_.tolerances[i];
    p.dt = starts_.front().scenario->duration / static_cast<double>(p.steps);
    p.at = p.tolerance > 0 ? fmt::format("tolerance {:.1e}", p.tolerance)
                           : results::step_in_words(step_text(*starts_.front().scenario, p.steps));
    p.error = error;
    return p;
  }

  const std::vector<Start>& starts_;
  const Setting& setting_;
  const AdviseOptions& options_;
  Row row_;
  std::map<std::size_t, double> cpu_;
  std::string version_;
  int substeps_ = 1;
};

std::string family(const std::string& id) { return id.substr(0, id.find('/')); }

// The dearer ones that cannot be the cheapest, by the recorded runs, are not timed.
std::vector<Pick> candidates(std::vector<std::pair<double, Pick>> picks) {
  std::stable_sort(picks.begin(), picks.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Pick> result;
  for (const auto& [cpu, pick] : picks)
    if (result.size() < 2 || (result.size() < 5 && cpu < 3 * picks.front().first + 2e-5))
      result.push_back(pick);
  return result;
}

}  // namespace

std::span<const double> check_variations() {
  static constexpr double parts[] = {0.0043, -0.0071, 0.0127, -0.0156};
  return parts;
}

std::int64_t search_samples(const scenario::Scenario& scenario) {
  return std::min(coarsest_samples(scenario, 256, 64), ladder(scenario, 1, 1).samples);
}

std::vector<std::int64_t> fine_steps(std::int64_t samples, std::int64_t most, int per_octave) {
  std::vector<std::int64_t> steps = {samples};
  for (int i = 1; i < 40 * per_octave; ++i) {
    const std::int64_t next = samples * std::llround(std::exp2(static_cast<double>(i) / per_octave));
    if (next > most) break;
    if (next > steps.back()) steps.push_back(next);
  }
  return steps;
}

Setting setting_of(const Pick& pick, const std::vector<Setting>& settings) {
  return *std::find_if(settings.begin(), settings.end(), [&](const Setting& s) {
    return s.engine.id == pick.engine && s.integrator.name == pick.integrator;
  });
}

double error_from(const Start& start, const Setting& setting, std::int64_t steps, double tolerance,
                  const process::Limits& limits) {
  const Ran ran = measure_run(setting, *start.scenario, *start.yardstick, steps, tolerance, limits);
  return ran.point.errors.empty() ? std::nan("") : ran.point.errors[start.by];
}

// Why a pick has no cost, by pick.
std::map<const Pick*, std::string> time_picks(const std::vector<Pick*>& picks, const core::Scene& scene,
                                              const std::vector<Setting>& settings, double duration,
                                              int rounds, const process::Limits& limits) {
  std::vector<std::optional<process::Repetition>> best(picks.size());
  std::map<const Pick*, std::string> failed;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < picks.size(); ++i) {
      const Setting setting = setting_of(*picks[i], settings);
      Timed timed{setting.engine, {}, picks[i]->steps};
      timed.setup.dt = picks[i]->dt, timed.setup.tolerance = picks[i]->tolerance;
      timed.setup.integrator = setting.integrator.name;
      const double guess =
          best[i] ? best[i]->step_seconds + best[i]->load_seconds
                  : 1e-6 * static_cast<double>(picks[i]->steps) * static_cast<double>(scene.bodies.size());
      const TimedOnce once = time_once(timed, scene, guess, limits);
      const auto& time = once.least;
      if (!time) {
        failed[picks[i]] = once.reason;
        continue;
      }
      best[i] = best[i] ? least(*best[i], *time) : *time;
      picks[i]->cost = cost(*best[i], setting.integrator.adaptive, duration);
    }
  return failed;
}

void put_cheapest_first(std::vector<Pick>& picks) {
  constexpr double as_cheap = 1.05;
  std::stable_sort(picks.begin(), picks.end(), [](const Pick& a, const Pick& b) { return a.cost < b.cost; });
  const auto tied = std::find_if(picks.begin(), picks.end(), [&](const Pick& pick) {
    return !(pick.cost <= as_cheap * picks.front().cost);
  });
  const auto options = [](const Pick& pick) {
    return std::ranges::count_if(pick.engine, [](char c) { return c == '/' || c == ','; });
  };
  std::stable_sort(picks.begin(), tied,
                   [&](const Pick& a, const Pick& b) { return options(a) < options(b); });
}

std::vector<EngineAdvice> advise(const std::vector<Start>& starts, const std::vector<Setting>& settings,
                                 const AdviseOptions& options,
                                 const std::function<void(const Setting&)>& done) {
  std::vector<Found> found(settings.size());
  std::mutex reporting;
  in_parallel(settings.size(), options.workers, [&](std::size_t i) {
    try {
      found[i] = Search(starts, settings[i], options).find();
    } catch (const Cannot& cannot) {
      found[i].reason = cannot.reason;
    } catch (const core::InputError& error) {
      if (settings[i].asked) throw;
      found[i].reason = error.what();
    }
    const std::scoped_lock lock(reporting);
    if (done) done(settings[i]);
  });

  std::vector<EngineAdvice> advice;
  std::vector<std::vector<Pick>> picks;
  for (std::size_t i = 0; i < settings.size();) {
    EngineAdvice one;
    one.engine = family(settings[i].engine.id);
    std::vector<std::pair<double, Pick>> met;
    double ten_cpu = HUGE_VAL;
    for (; i < settings.size() && family(settings[i].engine.id) == one.engine; ++i) {
      if (found[i].pick) met.emplace_back(found[i].cpu, *found[i].pick);
      if (found[i].best && (!one.best || found[i].best->error < one.best->error)) one.best = found[i].best;
      if (found[i].ten_times && found[i].ten_cpu < ten_cpu)
        one.ten_times = found[i].ten_times, ten_cpu = found[i].ten_cpu;
      if (!found[i].version.empty()) one.version = found[i].version;
      if (!found[i].reason.empty()) one.reason = found[i].reason;
    }
    if (one.best) one.reason.clear();
    picks.push_back(candidates(std::move(met)));
    advice.push_back(std::move(one));
  }
  std::vector<Pick*> timed;
  for (std::size_t e = 0; e < advice.size(); ++e) {
    for (Pick& pick : picks[e]) timed.push_back(&pick);
    if (advice[e].ten_times) timed.push_back(&*advice[e].ten_times);
  }
  const scenario::Scenario& scenario = *starts.front().scenario;
  const auto failed =
      time_picks(timed, scenario.scene, settings, scenario.duration, options.rounds, options.limits);
  for (std::size_t e = 0; e < advice.size(); ++e) {
    // What cannot be timed has no cost to be chosen by.
    for (const Pick& pick : picks[e])
      if (const auto why = failed.find(&pick); why != failed.end()) advice[e].reason = why->second;
    if (advice[e].ten_times && failed.contains(&*advice[e].ten_times)) advice[e].ten_times.reset();
    std::erase_if(picks[e], [&](const Pick& pick) { return failed.contains(&pick); });
    if (picks[e].empty() && !advice[e].reason.empty()) advice[e].best.reset();
    put_cheapest_first(picks[e]);
    if (!picks[e].empty()) advice[e].pick = picks[e][0];
    if (picks[e].size() > 1) advice[e].runner_up = picks[e][1];
    advice[e].over_budget = options.budget > 0 && advice[e].pick && !(advice[e].pick->cost <= options.budget);
  }
  return advice;
}

}  // namespace cylon::study
