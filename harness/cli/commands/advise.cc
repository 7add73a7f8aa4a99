// cylon advise
#include "harness/cli/commands/advise_verify.h"

#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/progress.h"
#include "harness/cli/provenance_now.h"
#include "harness/cli/selection.h"
#include "harness/cli/workers.h"
#include "harness/core/input_error.h"
#include "harness/process/interruption.h"
#include "harness/study/advise.h"
#include "harness/study/features.h"
#include "harness/study/settings.h"
#include "reports/advice_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace cylon::cli {
namespace {

struct Options {
  std::string file, observable, json;
  Brought brought;
  study::SettingsRequest wanted;
  study::AdviseOptions how;
  int jobs = 0;
  double work = 1 << 20, timeout = 60;
  ShardOptions shard;
  bool no_features = false, verify = false, resume = false;
};

std::vector<results::Pick> chosen(const results::Advice& advice) {
  std::vector<results::Pick> picks;
  for (const results::EngineAdvice& one : advice.engines)
    if (one.pick && !one.engine.ends_with("-float")) picks.push_back(*one.pick);
  return picks;
}

// Of no engine that ran anything, as `cylon trade` has it: 4.
int exit_code(const results::Advice& advice) {
  const bool ran = std::ranges::any_of(advice.engines,
                                       [](const results::EngineAdvice& one) { return one.pick || one.best; });
  if (!ran) return nothing_selected;
  const bool any = std::any_of(advice.engines.begin(), advice.engines.end(),
                               [](const results::EngineAdvice& one) { return one.pick && !one.over_budget; });
  return any ? ok : differs;
}

int run(const Context& context, Options options) {
  require_writable(options.json);
  options.how.limits.run_seconds = options.timeout;
  options.how.most = static_cast<std::int64_t>(options.work);
  options.how.workers = worker_count(context, options.jobs);
  const auto rows = with_brought(context, options.brought);
  if (options.verify && !options.json.empty())
    throw core::InputError(
        "--json: of `cylon advise FILE`; --verify prints lines and keeps them for --resume");
  if (options.verify)
    return verify_advice(context, {.wanted = options.wanted,
                                   .how = options.how,
                                   .rows = rows,
                                   .only = options.file,
                                   .observable = options.observable,
                                   .shard = options.shard,
                                   .resume = options.resume});
  if (context.farm || options.resume || !(options.shard == ShardOptions()))
    throw core::InputError("--shard, --resume and cylon farm are of `cylon advise --verify` alone");
  if (options.file.empty()) throw core::InputError("a scenario is missing: cylon advise FILE --tolerance X");
  const scenario::Scenario scenario = scenario::load(find_scenario(context, options.file));
  const auto starts = study::starts(scenario, study::check_variations(), study::search_samples(scenario),
                                    options.observable, rows, options.how.limits);
  const process::Interruptible until_told;
  results::Advice advice;
  advice.scenario = scenario.name, advice.duration = scenario.duration;
  advice.tolerance = options.how.tolerance, advice.budget = options.how.budget;
  if (!starts.empty()) {
    const results::TradeMeasure& measure = starts.front().yardstick->measures()[starts.front().by];
    advice.measure = measure.name, advice.against = measure.against;
    advice.starts = static_cast<int>(starts.size());
    const auto settings = study::settings(scenario, rows, options.wanted);
    int searched = 0;
    advice.engines = study::advise(starts, settings, options.how, [&](const study::Setting& setting) {
      ++searched;
      show_progress(context.progress,
                    fmt::format("[{}/{}] {}", searched, settings.size(),
                                plain_line(setting.engine.id + " " + setting.integrator.name)));
    });
    if (!options.no_features)
      advice.features = study::price_features(starts.front(), chosen(advice), settings, rows,
                                              options.how.rounds, options.how.limits);
    show_progress(context.progress, "");
  }
  if (options.json != "-")
    std::cout << reports::advice_text(
        advice, {.width = context.width, .utf8 = context.utf8, .colour = context.colour});
  if (!options.json.empty()) write_whole(options.json, reports::advice_json(advice, provenance_now(context)));
  return exit_code(advice);
}

}  // namespace

Command add_advise(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option("file", options->file, "A scenario file, or the name of a shipped scenario")
      ->type_name("FILE");
  app.add_option("--tolerance", options->how.tolerance,
                 "Largest acceptable error, relative to the range of the motion (angles: rad)")
      ->type_name("X")
      ->capture_default_str()
      ->check(positive(1));
  app.add_option("--observable", options->observable,
                 "Quantity whose error counts: trajectory, position, energy, events, …; default: trajectory")
      ->type_name("NAME");
  app.add_option("--budget", options->how.budget,
                 "Available CPU seconds per simulated second; settings that need more are marked")
      ->type_name("S")
      ->check(positive(1e9));
  options->wanted.searched = true;
  add_engines_option(
      app, options->wanted.engines,
      "all; an engine without options stands for those of its settings that matter to the scene");
  add_integrators_option(app, options->wanted.integrators, "all integrators of each engine");
  app.add_option("--work", options->work, "Largest number of bodies times steps of one run")
      ->type_name("N")
      ->default_str(fmt::format("{:.0f}", options->work))
      ->check(positive(1e12));
  app.add_option("--rounds", options->how.rounds, "Number of timings of each finalist, interleaved")
      ->type_name("N")
      ->capture_default_str()
      ->check(in_range(1, 1000));
  app.add_flag("--no-features", options->no_features, "Do not measure the cost of each part of the scene");
  add_jobs_option(app, options->jobs, "Number of searches to run at the same time; default: all processors");
  add_timeout_option(app, options->timeout);
  app.add_option("--json", options->json, "Write the advice as JSON; - is stdout. Not of --verify")
      ->type_name("FILE");
  app.add_flag("--verify", options->verify,
               "Check the advice on twenty scenarios, or on FILE: run it from new initial states and compare "
               "its cost with the best of a full sweep. Takes minutes");
  add_shard_options(app, options->shard, "scenarios of --verify");
  app.add_flag(
      "--resume", options->resume,
      "Continue an interrupted --verify in this folder (.cylon/advise.jsonl): finished scenarios are not "
      "repeated");
  add_brought_options(app, options->brought);
  app.footer(
      "The search uses the order of each integrator. Each result is checked from other initial states\n"
      "(velocities or gravity changed by up to 1.6 %). Exit code 1: no engine meets the tolerance in the "
      "budget;\n4: no engine can run the scene, or there is nothing to measure.");
  return [=, &context] { return run(context, *options); };
}

}  // namespace cylon::cli
