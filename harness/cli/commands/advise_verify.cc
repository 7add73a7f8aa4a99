// cylon advise --verify
#include "harness/cli/commands/advise_verify.h"

#include "harness/cli/farm.h"
#include "harness/cli/identity_of.h"
#include "harness/cli/line_file.h"
#include "harness/cli/part.h"
#include "harness/cli/timed_cores.h"
#include "harness/core/worst.h"
#include "harness/process/interruption.h"
#include "harness/results/duration.h"
#include "harness/results/substeps.h"
#include "harness/study/ladder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <optional>

namespace cylon::cli {
namespace {

using nlohmann::json;
using study::Setting;
using study::Start;

// Of every kind of motion: flight, springs, tops, joints, drag, contacts.
constexpr const char* twenty[] = {"projectile",          "projectile_drag",
                                  "bouncing_sphere",     "bouncing_sphere_elastic",
                                  "two_sphere_oblique",  "spring_zero_length",
                                  "spring_orbit",        "spring_chain",
                                  "damped_spring_under", "driven_spring",
                                  "free_symmetric_top",  "free_asymmetric_top",
                                  "dzhanibekov",         "heavy_top",
                                  "heavy_top_nutating",  "spherical_pendulum",
                                  "physical_pendulum",   "kepler",
                                  "block_slides",        "rotating_frame"};

// Starts that no search has seen.
constexpr double unseen[] = {0.0028, -0.0094, 0.0141};

constexpr double allowed_cost = 1.5;

// The worst error over the unseen starts.
double worst_error(const std::vector<Start>& starts, const Setting& setting, std::int64_t steps,
                   double tolerance, double target, const process::Limits& limits) {
  double worst = 0;
  for (std::size_t s = 1; s < starts.size() && worst <= target; ++s)
    worst = core::worst(study::error_from(starts[s], setting, steps, tolerance, limits), worst);
  return worst;
}

// What came of one scenario, as the journal keeps it.
struct Answer {
  std::string lines;
  int advised = 0, held = 0, dear = 0;
};

json to_json(const Answer& a) {
  return {{"lines", a.lines}, {"advised", a.advised}, {"held", a.held}, {"dear", a.dear}};
}

Answer answer_from(const json& j) { return {j.at("lines"), j.at("advised"), j.at("held"), j.at("dear")}; }

std::string at(const results::Pick& pick) { return results::with_substeps(pick.at, pick.substeps); }

results::Pick pick_of(const results::TradeSeries& series, const results::TradePoint& point, std::size_t by) {
  results::Pick pick;
  pick.engine = series.engine, pick.integrator = series.integrator;
  pick.substeps = series.substeps;
  pick.steps = point.steps, pick.dt = point.dt, pick.tolerance = point.tolerance;
  pick.at = point.tolerance > 0 ? fmt::format("tolerance {:.0e}", point.tolerance)
                                : results::step_in_words(point.dt_text);
  pick.error = point.errors[by], pick.cost = point.cost;
  return pick;
}

// The cheapest point of an engine's sweep that serves from the unseen starts too.
std::optional<results::Pick> best_of_sweep(const results::TradeTable& table, const std::string& engine,
                                           double target, const std::vector<Start>& starts,
                                           const std::vector<Setting>& settings,
                                           const process::Limits& limits) {
  std::vector<results::Pick> points;
  for (const results::TradeSeries& series : table.series)
    if (series.engine.substr(0, series.engine.find('/')) == engine)
      for (const results::TradePoint& point : series.points)
        if (!point.errors.empty() && point.errors[table.by] <= target && std::isfinite(point.cost))
          points.push_back(pick_of(series, point, table.by));
  std::stable_sort(points.begin(), points.end(),
                   [](const results::Pick& a, const results::Pick& b) { return a.cost < b.cost; });
  for (const results::Pick& pick : points)
    if (worst_error(starts, study::setting_of(pick, settings), pick.steps, pick.tolerance, target, limits) <=
        target)
      return pick;
  return std::nullopt;
}

Answer verify(const Verification& ask, const scenario::Scenario& scenario) {
  Answer tally;
  const double target = ask.how.tolerance;
  const auto bodies = static_cast<std::int64_t>(scenario.scene.bodies.size());
  const std::int64_t samples = study::search_samples(scenario);
  // Every step of it, a factor of sqrt 2 apart.
  const study::Ladder ladder{samples, study::fine_steps(samples, ask.how.most / bodies, 2)};
  const auto seen = study::starts(scenario, study::check_variations(), ladder.samples, ask.observable,
                                  ask.rows, ask.how.limits);
  const auto fresh =
      study::starts(scenario, unseen, ladder.samples, ask.observable, ask.rows, ask.how.limits);
  if (seen.empty()) return tally;
  std::vector<Setting> settings = study::settings(scenario, ask.rows, ask.wanted);
  const auto advice = study::advise(seen, settings, ask.how, {});

  study::SweepOptions sweep;
  sweep.tolerances = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};
  sweep.by = seen.front().by;
  sweep.workers = ask.how.workers, sweep.rounds = 1, sweep.limits = ask.how.limits;
  study::Memory memory;
  std::vector<Setting> swept = settings;
  results::TradeTable table =
      study::sweep_errors(scenario, *seen.front().yardstick, ladder, swept, sweep, memory, {});
  // Only what serves needs a time, and only the coarsest of each series that does.
  for (results::TradeSeries& series : table.series) {
    int kept = 0;
    std::erase_if(series.points, [&](const results::TradePoint& p) {
      return p.errors.empty() || !(p.errors[table.by] <= target) || ++kept > 6;
    });
  }
  study::sweep_times(table, scenario, swept, sweep, memory, {});

  for (const results::EngineAdvice& one : advice) {
    // An engine that only comes closer to the tolerance than the margin is not advised.
    std::optional<results::Pick> best = best_of_sweep(
        table, one.engine, one.pick ? target : target / study::margin, fresh, settings, ask.how.limits);
    if (!one.pick) {
      tally.lines += fmt::format(
          "{:<24} {:<22} {}\n", scenario.name, one.engine,
          best       ? fmt::format("MISSED: {} {} at {} serves", best->engine, best->integrator, at(*best))
          : one.best ? fmt::format("not reachable, best {:.1e}", one.best->error)
                     : "cannot run it");
      if (best) ++tally.advised, ++tally.dear;
      continue;
    }
    ++tally.advised;
    results::Pick pick = *one.pick;
    const double error = worst_error(fresh, study::setting_of(pick, settings), pick.steps, pick.tolerance,
                                     1e300, ask.how.limits);
    std::vector<results::Pick*> both = {&pick};
    if (best) both.push_back(&*best);
    study::time_picks(both, scenario.scene, settings, scenario.duration, ask.how.rounds, ask.how.limits);
    const double ratio = best ? pick.cost / best->cost : 0;
    tally.held += error <= target;
    tally.dear += ratio > allowed_cost;
    tally.lines +=
        fmt::format("{:<24} {:<22} {} {} at {}: error {:.1e} from {} new initial states {}; {:.1e} s/s, {}\n",
                    scenario.name, one.engine, pick.engine, pick.integrator, at(pick), error,
                    fresh.size() - 1, error <= target ? "holds" : "FAILS", pick.cost,
                    best ? fmt::format("{:.2f} of the sweep's best ({} {} at {}){}", ratio, best->engine,
                                       best->integrator, at(*best), ratio > allowed_cost ? " DEAR" : "")
                         : "no setting of the sweep meets the tolerance");
  }
  return tally;
}

// All that decides the answer but its times.
Unit unit_of(const Verification& ask, const scenario::Scenario& scenario) {
  std::string engines;
  for (const process::EngineRow& row : ask.rows) engines += row.id + " " + identity_of(row) + " ";
  return {fmt::format("{}/{}/{} {} {} {} {} {} {}/{}", scenario.name, scenario.hash, ask.how.tolerance,
                      ask.how.budget, ask.how.most, ask.how.rounds, ask.observable,
                      fmt::join(ask.wanted.engines, ","), fmt::join(ask.wanted.integrators, ","), engines),
          scenario.name};
}

std::map<std::string, Answer> answers_in(const LineFile& file) {
  std::map<std::string, Answer> known;
  file.read([&](const json& line) {
    if (line.contains("advice")) known[line.at("key")] = answer_from(line.at("advice"));
  });
  return known;
}

}  // namespace

int verify_advice(const Context& context, const Verification& ask) {
  if (context.farm) context.farm->require_own_cores("`cylon advise --verify` measures times");
  const std::optional<Shard> shard = shard_asked(ask.shard, context.farm);
  std::vector<std::unique_ptr<scenario::Scenario>> scenarios;
  const auto add = [&](const std::string& name) {
    scenarios.push_back(std::make_unique<scenario::Scenario>(scenario::load(find_scenario(context, name))));
  };
  if (ask.only.empty())
    for (const char* name : twenty) add(name);
  else
    add(ask.only);
  identify(ask.rows);
  Part part{"advise", shard ? shard->index : 1, shard ? shard->count : 1, {}};
  for (const auto& scenario : scenarios) part.units.push_back(unit_of(ask, *scenario));
  const std::vector<bool> own = own_units(shard, part, ask.resume);
  std::vector<Unit> units = part.units;
  keep(own, units), keep(own, scenarios);
  std::optional<TimedCores> cores;
  if (!context.farm && !units.empty())
    cores.emplace(shard ? TimedCores::Taken::wait : TimedCores::Taken::warn);
  LineFile journal(journal_file("advise", shard));
  const std::map<std::string, Answer> known =
      ask.resume ? answers_in(journal) : std::map<std::string, Answer>();
  journal.open(ask.resume);
  journal.add(to_json(part));
  if (shard && !journal.is_open())
    throw core::InputError("a shard is its journal, and there is none: nothing was run");

  const process::Interruptible until_told;
  Answer all;
  bool whole = true;
  const study::Next next = next_of(shard, units.size());
  while (const auto i = next()) try {
      const auto start = std::chrono::steady_clock::now();
      const auto found = known.find(units[*i].key);
      const Answer answer = found != known.end() ? found->second : verify(ask, *scenarios[*i]);
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      if (found == known.end())
        journal.add({{"key", units[*i].key},
                     {"cell", units[*i].name},
                     {"advice", to_json(answer)},
                     {"seconds", seconds.count()}});
      std::cout << answer.lines << std::flush;
      all.advised += answer.advised, all.held += answer.held, all.dear += answer.dear;
    } catch (const process::Interrupted&) {
      whole = false;
      break;
    }
  std::cout << fmt::format(
      "{} results: {} hold from new initial states, {} cost more than {} times the best found\n", all.advised,
      all.held, all.dear, allowed_cost);
  if (!whole) {
    std::cerr
        << "interrupted: these are the scenarios that are done; repeat the command with --resume in this "
           "folder to continue\n";
    return interrupted;
  }
  if (shard && !journal.is_open()) return harness_failure;
  return (shard && shard->farm) || (all.held == all.advised && all.dear == 0) ? ok : differs;
}

}  // namespace cylon::cli
