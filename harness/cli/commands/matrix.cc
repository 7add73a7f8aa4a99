// cylon matrix
#include "harness/cli/commands/app.h"
#include "harness/cli/commands/trade_sweep.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/workers.h"
#include "harness/core/input_error.h"
#include "harness/scenario/input.h"
#include "harness/study/settings.h"
#include "reports/step_matrix.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <set>

namespace cylon::cli {
namespace {

struct Options {
  std::vector<std::string> patterns;
  Brought brought;
  study::SettingsRequest wanted;
  std::string observable, json, html, at;
  int rounds = 3, jobs = 0;
  double finest = 1e-4, timeout = 60;
  ShardOptions shard;
  bool resume = false, others = false;
};

bool is_in_house(const std::string& id) {
  const std::string row = id.substr(0, id.find('/'));
  return row == "in-house" || row == "in-house-float";
}

// Of each engine the integrator that it takes by itself, which an expert's path may choose by the scene; where that one
// controls its error, also the first of fixed steps, for scenes that the engine steps through in any case.
std::vector<study::Setting> usual_ones(std::vector<study::Setting> all) {
  std::vector<study::Setting> kept;
  std::set<std::string> seen;
  for (study::Setting& setting : all) {
    const bool first = seen.insert(setting.engine.id).second;
    setting.by_itself = first && !setting.integrator.adaptive;
    if (first || setting.first_fixed) kept.push_back(std::move(setting));
  }
  return kept;
}

std::vector<study::Setting> settings_of(const Options& options, const scenario::Scenario& scenario,
                                        const std::vector<process::EngineRow>& rows) {
  study::SettingsRequest wanted = options.wanted;
  const bool named = !wanted.engines.empty();
  if (!named) wanted.engines = {"*"};  // every usual row, without the variants that `trade` adds
  std::vector<study::Setting> settings =
      study::settings(scenario, named ? rows : process::usual(rows), wanted);
  if (options.others) std::erase_if(settings, [](const auto& s) { return is_in_house(s.engine.id); });
  return wanted.integrators.empty() ? usual_ones(std::move(settings)) : settings;
}

// What docs/causes.md has on the motion of this engine in this scene.
std::string cause_of(const scenario::Expectations& expectations, const std::string& scenario,
                     const std::string& engine) {
  const auto row = std::ranges::find_if(expectations.rows(), [&](const scenario::Expectations::Row& r) {
    return r.scenario == scenario && r.engine == engine && r.claim.find(" follows ") != std::string::npos;
  });
  return row == expectations.rows().end() ? "" : row->cause;
}

results::TradeTable sweep_of(const Context& context, const Options& options,
                             const scenario::Expectations& expectations, const scenario::Scenario& scenario,
                             TradeJournal& journal) {
  const auto rows = with_brought(context, options.brought);
  study::SweepOptions how;
  how.tolerances.assign(results::reach_errors.begin(), results::reach_errors.end());
  how.reach = how.tolerances;
  how.workers = worker_count(context, options.jobs);
  how.rounds = options.rounds;
  how.limits.run_seconds = options.timeout;
  const Sweep plan{scenario, rows, study::ladder_down_to(scenario, options.finest), how, options.observable};
  results::TradeTable table =
      sweep(context, plan, journal, [&] { return settings_of(options, scenario, rows); });
  for (results::TradeSeries& series : table.series)
    series.cause = cause_of(expectations, table.scenario, series.engine);
  return table;
}

// Of the options those that decide which runs are made.
std::vector<std::string> asked(const Options& o) {
  return {fmt::format("{} {} {}", fmt::join(o.wanted.engines, ","), fmt::join(o.wanted.integrators, ","),
                      o.others),
          fmt::format("{} {} {}", o.finest, o.rounds, o.observable)};
}

int matrix(const Context& context, const Options& options) {
  require_writable(std::vector<std::string>{options.json, options.html});
  const double at = options.at.empty() ? 0 : scenario::parse_step(options.at, "--at");
  if (at > 0 && at < options.finest)
    throw core::InputError(
        fmt::format("--at: {:g} s is below --finest, {:g} s: no such step is tried", at, options.finest));
  const scenario::Expectations expected = expectations(context);
  const auto each = [&](const scenario::Scenario& scenario, TradeJournal& journal) {
    return sweep_of(context, options, expected, scenario, journal);
  };
  return sweep_each(
      context,
      {"matrix", options.patterns, asked(options), options.shard, options.resume, options.rounds > 0}, each,
      [&](const Selection& selection, const std::vector<results::TradeTable>& tables) {
        const reports::ConsoleOptions style{
            .width = context.width, .utf8 = context.utf8, .colour = context.colour};
        if (options.json != "-" && options.html != "-")
          std::cout << (at > 0 ? reports::digits_text(tables, at, style)
                               : reports::steps_text(tables, style));
        write_tables(context, selection, tables, "Cylon: which step an engine needs", options.json,
                     options.html);
      });
}

}  // namespace

Command add_matrix(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option(
         "patterns", options->patterns,
         "Scenario names, globs or files, several joined by ':', excluded with '-'. Default: the suite "
         "conformance")
      ->type_name("FILE|GLOB");
  add_engines_option(app, options->wanted.engines, "all but the optional ones");
  app.add_flag("--others", options->others, "Leave out the in-house engine");
  add_integrators_option(app, options->wanted.integrators, "each engine's default");
  app.add_option("--at", options->at,
                 "Print digits, -log10 of the error, at the coarsest tried step of at most S [s] instead")
      ->type_name("S");
  app.add_option("--finest", options->finest, "Finest step that is tried [s]")
      ->type_name("S")
      ->capture_default_str()
      ->check(positive(1e6));
  app.add_option("--observable", options->observable,
                 "Quantity whose error decides: trajectory, position, energy, events, …; default: trajectory "
                 "where an exact solution is known")
      ->type_name("NAME");
  add_sweep_options(app, options->rounds, options->jobs, options->timeout);
  app.add_option("--json", options->json,
                 "Write the sweeps as `cylon trade --json` does, for `cylon report`; - is stdout")
      ->type_name("FILE");
  app.add_option("--html", options->html, "Write the matrix and the plots as one HTML file; - is stdout")
      ->type_name("FILE");
  add_shard_options(app, options->shard, "scenarios");
  app.add_flag(
      "--resume", options->resume,
      "Continue an interrupted sweep in this folder (.cylon/matrix.jsonl): finished runs are not repeated");
  add_brought_options(app, options->brought);
  app.footer(
      "Steps are halved from about 64 times the nominal one. Errors do not depend on times. Exit code 4: no\n"
      "engine ran anything.");
  return [=, &context] { return matrix(context, *options); };
}

}  // namespace cylon::cli
