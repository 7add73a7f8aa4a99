// cylon predict
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/commands/estimates.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/workers.h"
#include "harness/core/input_error.h"
#include "harness/process/engine_table.h"
#include "harness/process/interruption.h"
#include "harness/study/parallel.h"
#include "harness/study/session_runner.h"
#include "harness/validation/length_scale.h"
#include "harness/validation/score.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>

namespace cylon::cli {
namespace {

using nlohmann::ordered_json;
using validation::Estimate, validation::RunScore, validation::Summary;

struct Options {
  std::string experiment, json, step;
  std::vector<std::string> engines, workers, values;
  validation::Band band;
  int jobs = 0;
  double timeout = 60;
};

std::vector<RunScore> scores(const Context& context, const Options& options, const measured::Experiment& e,
                             const process::EngineChoice& engine) {
  const study::Runner runner = study::worker_runner(engine, {.run_seconds = options.timeout});
  std::vector<RunScore> all(e.runs.size());
  std::mutex guard;
  std::size_t done = 0;
  study::in_parallel(e.runs.size(), worker_count(options.jobs), [&](std::size_t i) {
    all[i] = validation::score(e, i, runner, options.band);
    const std::scoped_lock lock(guard);
    if (++done; context.progress)
      std::cerr << fmt::format("\r{}: {} of {} runs\x1b[K", engine.id, done, e.runs.size()) << std::flush;
  });
  if (context.progress) std::cerr << "\r\x1b[K" << std::flush;
  return all;
}

std::string told_length(const char* what, const Estimate& scale, const char* unit) {
  if (scale.runs < 2) return fmt::format("  {:<22} not known ({} runs)\n", what, scale.runs);
  const auto answer = validation::answer({1, 1}, scale.interval.low, scale.interval.high);
  return fmt::format("  {:<22} {:.4f} [{:.4f}, {:.4f}] of {} ({} runs){}\n", what, scale.value,
                     scale.interval.low, scale.interval.high, unit, scale.runs,
                     answer == validation::Answer::inside ? "" : ": 1 is outside the interval");
}

// The prediction horizon of each engine for the angles of a chain.
int predict_chain(const Options& options, const measured::Experiment& e,
                  const std::vector<process::EngineChoice>& engines) {
  std::cout << fmt::format(
      "Predictions from the first frame, steps of {:.6g} s; medians over runs, with 95 % intervals (a chain "
      "has no "
      "band: --members and --seed say nothing):\n",
      e.model.step);
  const process::Interruptible until_told;
  std::vector<std::size_t> runs(e.runs.size());
  std::iota(runs.begin(), runs.end(), 0);
  ordered_json told_engines = ordered_json::array();
  for (const process::EngineChoice& engine : engines) {
    const auto each = validation::horizons(
        e, runs, study::session_runner(engine, {.run_seconds = options.timeout}), worker_count(options.jobs));
    const validation::HorizonSummary s = validation::summary(each);
    std::cout << plain(engine.id + "\n" + told(s)) << std::flush;
    ordered_json told_engine = to_json(s), told_runs = ordered_json::array();
    for (const validation::Horizon& h : each) told_runs.push_back(to_json(h));
    told_engine["engine"] = engine.id, told_engine["each"] = told_runs;
    told_engines.push_back(told_engine);
  }
  if (!options.json.empty())
    write_whole(options.json, ordered_json{{"format", "cylon-prediction/1"},
                                           {"title", e.title},
                                           {"source", e.source},
                                           {"licence", e.licence},
                                           {"known", e.known},
                                           {"model", e.model.hash},
                                           {"step", e.model.step},
                                           {"set", options.values},
                                           {"engines", told_engines}}
                                      .dump(1, ' ', true) +
                                  "\n");
  return ok;
}

int predict(const Context& context, const Options& options) {
  require_writable(options.json);
  measured::Experiment e = measured::read(options.experiment);
  set_step(e, options.step);
  e = set_values(e, options.values);
  const auto rows = with_workers(context, options.workers);
  const std::vector<std::string> ids =
      options.engines.empty() ? process::compared_engines() : options.engines;
  std::vector<process::EngineChoice> engines;
  for (const std::string& id : ids) engines.push_back(process::parse_engine(id, rows));

  std::cout << plain(fmt::format("{}: {} runs\n", e.title, e.runs.size()));
  for (const std::string& known : e.known) std::cout << plain(fmt::format("  known: {}\n", known));
  for (const std::string& value : options.values) std::cout << plain(fmt::format("  set: {}\n", value));
  if (e.coordinates == measured::Coordinates::chain) return predict_chain(options, e, engines);
  const validation::LengthScale lengths = validation::length_scale(e);
  std::cout << "Lengths of the data, measured/true, with 95 % intervals:\n"
            << told_length("from free flight", lengths.flight, "the fall")
            << told_length("from heights at rest", lengths.rest, "the height");
  std::cout << fmt::format(
      "Predictions from the first frame, steps of {} s; medians over runs, with 95 % intervals:\n",
      options.step.empty() ? e.model.step_text : options.step);
  const process::Interruptible until_told;
  std::vector<std::vector<RunScore>> all;
  ordered_json told_engines = ordered_json::array();
  for (const process::EngineChoice& engine : engines) {
    all.push_back(scores(context, options, e, engine));
    const Summary s = validation::summary(all.back());
    std::cout << plain(engine.id + "\n" + told(s, options.band.members)) << std::flush;
    ordered_json runs = ordered_json::array();
    for (const RunScore& r : all.back()) runs.push_back(to_json(r));
    ordered_json told_engine = to_json(s);
    told_engine["engine"] = engine.id, told_engine["each"] = runs;
    told_engines.push_back(told_engine);
  }
  const auto pairs = validation::nearer(all);
  ordered_json compared = ordered_json::array();
  for (std::size_t j = 0; j < pairs.size(); ++j) {
    const auto& [one, other, p, answer] = pairs[j];
    const std::string& nearest = answer == validation::Answer::inside    ? engines[0].id
                                 : answer == validation::Answer::outside ? engines[j + 1].id
                                                                         : "undecided";
    std::cout << plain(fmt::format("nearer at rest: {} in {} runs, {} in {}: {} (p = {:.2g}, Holm)\n",
                                   engines[0].id, one, engines[j + 1].id, other, nearest, p));
    compared.push_back({{"one", engines[0].id},
                        {"other", engines[j + 1].id},
                        {"runs_of_one", one},
                        {"runs_of_other", other},
                        {"p", p},
                        {"nearer", nearest}});
  }
  if (!options.json.empty())
    write_whole(
        options.json,
        ordered_json{{"format", "cylon-prediction/1"},
                     {"title", e.title},
                     {"source", e.source},
                     {"licence", e.licence},
                     {"known", e.known},
                     {"model", e.model.hash},
                     {"step", e.model.step},
                     {"set", options.values},
                     {"members", options.band.members},
                     {"seed", options.band.seed},
                     {"lengths", {{"flight", to_json(lengths.flight)}, {"rest", to_json(lengths.rest)}}},
                     {"engines", told_engines},
                     {"nearer", compared}}
                .dump(1, ' ', true) +
            "\n");
  return ok;
}

}  // namespace

Command add_predict(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option("experiment", options->experiment, "File that describes measured motions (docs/measured.md)")
      ->type_name("FILE")
      ->required();
  add_engines_option(app, options->engines, "those of the published tables");
  add_step_option(app, options->step);
  app.add_option("--set", options->values,
                 "Parameter of the file with a value, as cylon fit found it; may be given again")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_option(
         "--members", options->band.members,
         "Predictions of the band of each run, from uncertain starts and materials; 39 make 95 %, 0 none")
      ->type_name("N")
      ->check(in_range(0, 10'000))
      ->capture_default_str();
  app.add_option("--seed", options->band.seed, "Of the band")
      ->type_name("S")
      ->check(whole(std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  app.add_option("--json", options->json, "Write everything, run by run, to this file; - is stdout")
      ->type_name("FILE");
  add_jobs_option(app, options->jobs, "Number of runs to predict at the same time; default: all processors");
  add_timeout_option(app, options->timeout);
  add_worker_option(app, options->workers);
  app.footer(
      "Validation: what is judged is the model with its parameters on an engine, never an engine alone. The "
      "results\n"
      "do not depend on the number of jobs.");
  return [=, &context] { return predict(context, *options); };
}

}  // namespace cylon::cli
