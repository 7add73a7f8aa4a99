// cylon trade
#include "harness/cli/commands/app.h"
#include "harness/cli/commands/trade_sweep.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/selection.h"
#include "harness/cli/workers.h"
#include "harness/core/input_error.h"
#include "harness/scenario/input.h"
#include "harness/study/settings.h"
#include "reports/trade_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace cylon::cli {
namespace {

struct Options {
  std::vector<std::string> patterns, steps;
  Brought brought;
  study::SettingsRequest wanted;
  std::vector<double> tolerances;
  std::string observable, json, csv, svg, html;
  int rungs = 12, rounds = 3, jobs = 0;
  double work = 1 << 18, timeout = 60, target = 0;
  ShardOptions shard;
  bool resume = false, verbose = false;
};

study::Ladder ladder_for(const Options& options, const scenario::Scenario& scenario) {
  if (options.steps.empty()) {
    const double bodies = static_cast<double>(std::max<std::size_t>(1, scenario.scene.bodies.size()));
    return study::ladder(scenario, options.rungs, static_cast<std::int64_t>(options.work / bodies));
  }
  std::vector<double> steps;
  for (const std::string& word : options.steps) steps.push_back(scenario::parse_step(word, "--dt"));
  return study::ladder(scenario, steps);
}

study::SweepOptions sweep_options(const Context& context, const Options& options) {
  study::SweepOptions sweep;
  sweep.tolerances = options.tolerances;
  std::sort(sweep.tolerances.rbegin(), sweep.tolerances.rend());
  sweep.workers = worker_count(context, options.jobs);
  sweep.rounds = options.rounds;
  sweep.limits.run_seconds = options.timeout;
  return sweep;
}

results::TradeTable sweep_of(const Context& context, const Options& options,
                             const scenario::Scenario& scenario, TradeJournal& journal) {
  const auto rows = with_brought(context, options.brought);
  const Sweep plan{scenario, rows, ladder_for(options, scenario), sweep_options(context, options),
                   options.observable};
  results::TradeTable table =
      sweep(context, plan, journal, [&] { return study::settings(scenario, rows, options.wanted); });
  table.target = options.target;
  return table;
}

// Of the options those that decide which runs are made.
std::vector<std::string> asked(const Options& o) {
  return {
      fmt::format("{} {} {}", fmt::join(o.wanted.engines, ","), fmt::join(o.wanted.integrators, ","),
                  fmt::join(o.steps, ",")),
      fmt::format("{} {} {} {} {}", fmt::join(o.tolerances, ","), o.rungs, o.work, o.rounds, o.observable)};
}

// FILE.svg, or FILE-scenario.svg where there are several.
std::string svg_name(const std::string& given, const std::string& scenario, bool several) {
  if (!several || given == "-") return given;
  const std::filesystem::path path = given;
  return (path.parent_path() /
          fmt::format("{}-{}{}", path.stem().string(), scenario, path.extension().string()))
      .string();
}

int trade(const Context& context, const Options& options) {
  require_writable(std::vector<std::string>{options.json, options.csv, options.svg, options.html});
  const bool quiet = options.json == "-" || options.csv == "-" || options.svg == "-" || options.html == "-";
  const reports::ConsoleOptions style{.width = context.width, .utf8 = context.utf8, .colour = context.colour};
  bool first = true;
  const auto each = [&](const scenario::Scenario& scenario, TradeJournal& journal) {
    results::TradeTable table = sweep_of(context, options, scenario, journal);
    if (!quiet)
      std::cout << (first ? "" : "\n") << reports::trade_text(table, style, options.verbose) << std::flush;
    first = false;
    return table;
  };
  return sweep_each(
      context, {"trade", options.patterns, asked(options), options.shard, options.resume, options.rounds > 0},
      each, [&](const Selection& selection, const std::vector<results::TradeTable>& tables) {
        write_tables(context, selection, tables, "Cylon: speed against accuracy", options.json, options.html);
        if (!options.csv.empty()) write_whole(options.csv, reports::trade_csv(tables));
        if (options.svg.empty()) return;
        for (const results::TradeTable& table : tables)
          if (!table.measures.empty())
            write_whole(svg_name(options.svg, table.scenario, tables.size() > 1),
                        reports::to_svg(reports::trade_plot(table)));
      });
}

}  // namespace

Command add_trade(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  options->tolerances = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};
  app.add_option("patterns", options->patterns,
                 "Scenario names, globs or files, several joined by ':', excluded with '-'")
      ->type_name("FILE|GLOB")
      ->required();
  add_engines_option(app, options->wanted.engines,
                     "all but the optional ones, with the variants that affect the scene");
  add_integrators_option(app, options->wanted.integrators, "all integrators of each engine");
  const Option steps = add_steps_option(
      app, options->steps,
      "a series of steps, each half of the one before, from about 64 times the nominal step");
  app.add_option("--steps", options->rungs, "Largest number of steps in the series")
      ->type_name("N")
      ->excludes(steps)
      ->capture_default_str()
      ->check(in_range(1, 40));
  app.add_option("--work", options->work,
                 "Largest number of bodies times steps of one run; the series of steps ends there")
      ->type_name("N")
      ->excludes(steps)
      ->capture_default_str()
      ->check(positive(1e12));
  app.add_option("--tolerance", options->tolerances,
                 "Tolerances to try with integrators that control their error. Repeatable. Default: 1e-2, "
                 "1e-3, ... 1e-12")
      ->type_name("T")
      ->allow_extra_args(false)
      ->check(positive(1));
  app.add_option("--observable", options->observable,
                 "Quantity whose error decides orders and the Pareto front: trajectory, position, energy, "
                 "events, …; default: trajectory where an exact solution is known")
      ->type_name("NAME");
  app.add_option("--target", options->target, "An error of interest: the tables show the cost to reach it")
      ->type_name("X")
      ->check(positive(1e6));
  add_sweep_options(app, options->rounds, options->jobs, options->timeout);
  app.add_option("--json", options->json,
                 "Write the tables as JSON, with times in a separate part; - is stdout")
      ->type_name("FILE");
  app.add_option("--csv", options->csv, "Write one row per point as CSV; - is stdout")->type_name("FILE");
  app.add_option("--svg", options->svg,
                 "Plot error against cost; with several scenarios, as FILE-scenario.svg")
      ->type_name("FILE");
  app.add_option("--html", options->html, "Write the plots and tables as one HTML file; - is stdout")
      ->type_name("FILE");
  add_shard_options(app, options->shard, "scenarios");
  app.add_flag(
      "--resume", options->resume,
      "Continue an interrupted sweep in this folder (.cylon/trade.jsonl): finished runs are not repeated");
  app.add_flag("-v,--verbose", options->verbose,
               "Print every point with all its errors and the point that dominates it");
  add_brought_options(app, options->brought);
  app.footer(
      "Cost is the CPU time of the worker's thread for all steps, without output, after a warm-up run. The\n"
      "shortest of several interleaved repetitions counts. Load time counts only for integrators with error\n"
      "control, because they may solve while they load. Errors do not depend on times; the Pareto front "
      "does.\n"
      "Engines in WebAssembly and in JavaScript have fronts of their own: their costs are not those of "
      "native "
      "code.");
  return [=, &context] { return trade(context, *options); };
}

}  // namespace cylon::cli
