// cylon fit
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/commands/estimates.h"
#include "harness/cli/commands/fit_journal.h"
#include "harness/cli/commands/fit_report.h"
#include "harness/cli/identity_of.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/progress.h"
#include "harness/cli/resumed.h"
#include "harness/cli/workers.h"
#include "harness/core/input_error.h"
#include "harness/core/recording.h"
#include "harness/process/client.h"
#include "harness/process/engine_table.h"
#include "harness/process/interruption.h"
#include "harness/scenario/input.h"
#include "harness/study/parallel.h"
#include "harness/study/session_runner.h"
#include "harness/validation/split.h"
#include "reports/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

namespace cylon::cli {
namespace {

using nlohmann::ordered_json;
using validation::Likelihood;

struct Options {
  std::string experiment, json, step, on = "first";
  std::vector<std::string> engines, parameters;
  Brought brought;
  int jobs = 0, folds = 0, runs = 0;
  bool resume = false;
  double timeout = 60;
};

// Runs that parameters are fitted on, and those that judge them.
struct Fold {
  std::vector<std::size_t> on, by;
};

std::vector<Fold> folds(const Options& options, const measured::Experiment& e) {
  const bool crossed = options.folds > 0;
  if (crossed && static_cast<std::size_t>(options.folds) > e.runs.size())
    throw core::InputError(fmt::format("--folds {}: {} has {} runs", options.folds, e.file, e.runs.size()));
  const auto part = validation::parts_of(e, crossed ? static_cast<std::size_t>(options.folds) : 2);
  const auto fold = [&](const auto& judges) {
    Fold made;
    for (std::size_t i = 0; i < part.size(); ++i) (judges(part[i]) ? made.by : made.on).push_back(i);
    return made;
  };
  std::vector<Fold> all;
  if (!crossed && options.on == "all") return {fold([](std::size_t) { return false; })};
  if (!crossed) return {fold([&](std::size_t p) { return p == (options.on == "first" ? 1u : 0u); })};
  for (std::size_t k = 0; k < static_cast<std::size_t>(options.folds); ++k)
    all.push_back(fold([&](std::size_t p) { return p == k; }));
  return all;
}

std::vector<measured::Parameter> wanted(const Options& options, const measured::Experiment& e) {
  if (e.parameters.empty()) throw core::InputError(fmt::format("{}: it has no [[parameter]] to fit", e.file));
  if (options.parameters.empty()) return e.parameters;
  std::vector<measured::Parameter> all;
  std::vector<std::string> names;
  for (const measured::Parameter& p : e.parameters) names.push_back(p.name);
  for (const std::string& word : options.parameters) {
    const auto found = std::ranges::find(e.parameters, word, &measured::Parameter::name);
    if (found == e.parameters.end())
      throw core::InputError(
          fmt::format("--parameters: {} has no '{}'{}", e.file, word, core::did_you_mean(word, names)));
    if (std::ranges::find(all, word, &measured::Parameter::name) != all.end())
      throw core::InputError(fmt::format("--parameters: '{}' twice", word));
    all.push_back(*found);
  }
  return all;
}

std::vector<std::string> names_of(const measured::Experiment& e, const std::vector<std::size_t>& runs) {
  std::vector<std::string> names;
  for (const std::size_t i : runs) names.push_back(e.runs[i].name);
  return names;
}

std::vector<validation::RunScore> rest_scores(const measured::Experiment& e,
                                              const std::vector<std::size_t>& runs,
                                              const study::Runner& runner, int jobs) {
  std::vector<validation::RunScore> all(runs.size());
  study::in_parallel(runs.size(), jobs,
                     [&](std::size_t i) { all[i] = validation::score(e, runs[i], runner, {.members = 0}); });
  return all;
}

// What of an engine's fit does not change by a repetition.
std::string key_of(const Options& options, const measured::Experiment& e, const process::EngineChoice& engine,
                   const std::vector<measured::Parameter>& parameters, const Fold& fold) {
  std::string key = fmt::format("{} {} {} {}", e.hash, engine.id, identity_of(engine.row), options.step);
  for (const measured::Parameter& p : parameters) key += " " + p.name;
  return key + fmt::format(" on {}", fmt::join(names_of(e, fold.on), ","));
}

FitRow fitted(const Context& context, const Options& options, const measured::Experiment& e,
              const process::EngineChoice& engine, const std::vector<measured::Parameter>& parameters,
              const Fold& fold, FitJournal& journal) {
  const int jobs = worker_count(options.jobs);
  const study::Runner runner = study::session_runner(engine, {.run_seconds = options.timeout});
  FitRow row;
  bool is_fitted = false;
  for (const std::size_t i : fold.on) row.fitted_data.push_back(e.runs[i].hash);
  row.engine = engine.id, row.fitted_on = names_of(e, fold.on), row.judged_on = names_of(e, fold.by);
  try {
    Likelihood likelihood(e, parameters, fold.on, runner, jobs);
    row.left_over = likelihood.left_over();
    std::optional<Likelihood> judge;  // made first: what it refuses is known before hours of fitting
    if (!fold.by.empty()) judge.emplace(e, parameters, fold.by, runner, jobs);
    validation::Memory memory = journal.memory(key_of(options, e, engine, parameters, fold));
    std::size_t evaluations = 0;
    memory.found = [&, write = memory.found](const validation::Evaluation& one) {
      write(one);
      ++evaluations;
      show_progress(context.progress,
                    fmt::format("{}: round {}, evaluation {}, -2 log L {:.3f} at {:.4g}", engine.id,
                                one.round, evaluations, one.deviance, fmt::join(one.values, " ")));
    };
    row.fit = validation::fit(likelihood, memory);
    show_progress(context.progress, "");
    if (!judge) return row;
    is_fitted = true;
    judge->renew(row.fit.values);
    row.deviances = judge->deviances(row.fit.values);
    const measured::Experiment after = measured::with_values(e, parameters, row.fit.values);
    if (e.coordinates == measured::Coordinates::free) {
      row.before = rest_scores(e, fold.by, runner, jobs),
      row.after = rest_scores(after, fold.by, runner, jobs);
    } else {
      row.horizon_before = validation::horizons(e, fold.by, runner, jobs);
      row.horizon_after = validation::horizons(after, fold.by, runner, jobs);
    }
  } catch (const study::RunFailed& failed) {
    (is_fitted ? row.judge_failure : row.failure) = failed.outcome.reason;
  }
  return row;
}

// An engine's folds, each run in its place of the table.
Judged together(const std::string& engine, const measured::Experiment& e, const std::vector<FitRow>& rows,
                const std::vector<Fold>& folds) {
  Judged all{engine, std::vector<double>(e.runs.size(), std::nan("")), {}, {}, {}, {}};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (std::size_t i = 0; i < rows[k].deviances.size(); ++i)
      all.deviances[folds[k].by[i]] = rows[k].deviances[i];
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    add(all.before, rows[k].before), add(all.after, rows[k].after);
    add(all.horizon_before, rows[k].horizon_before), add(all.horizon_after, rows[k].horizon_after);
  }
  return all;
}

int fit(const Context& context, const Options& options) {
  require_writable(options.json);
  std::ostream& out = options.json == "-" ? std::cerr : std::cout;
  measured::Experiment e = measured::read(options.experiment);
  set_step(e, options.step);
  const std::size_t measured_runs = e.runs.size();
  e = first_runs(e, options.runs);
  const auto parameters = wanted(options, e);
  const auto rows = with_brought(context, options.brought);
  const std::vector<Fold> parts = folds(options, e);
  const std::vector<std::string> ids =
      options.engines.empty() ? process::compared_engines() : options.engines;
  std::vector<process::EngineChoice> engines;
  for (const std::string& id : ids) engines.push_back(process::parse_engine(id, rows));
  for (const process::EngineChoice& engine : engines) process::require_possible(engine);

  const process::Interruptible until_told;
  FitJournal journal(".cylon/fit.jsonl", options.resume);
  if (options.resume) std::cerr << resumed(journal.known(), "evaluation");
  out << plain_line(fmt::format("{}: {} of {} runs, windows of {:g} s", e.title, e.runs.size(), measured_runs,
                                e.fit.horizon))
      << '\n';
  for (std::size_t k = 0; k < parts.size(); ++k)
    out << plain_line(fmt::format("  part {}: judged on {}: {}", k + 1,
                                  reports::counted(parts[k].by.size(), "run"),
                                  fmt::join(names_of(e, parts[k].by), " ")))
        << '\n';
  out << told_kinematics(e)
      << "Validation: parameters of greatest likelihood, with 95 % intervals: if the stated "
         "uncertainties are right,\n"
         "and from how much runs differ.\n";
  std::vector<Judged> judged;
  ordered_json fits = ordered_json::array(), judgements = ordered_json::array(),
               compared = ordered_json::array();
  bool failed = false;
  const bool whole = process::completes([&] {
    for (const process::EngineChoice& engine : engines) {
      std::vector<FitRow> of_engine;
      for (const Fold& fold : parts) {
        of_engine.push_back(fitted(context, options, e, engine, parameters, fold, journal));
        failed = failed || !of_engine.back().failure.empty();
        out << plain(told(of_engine.back(), parameters)) << std::flush;
        fits.push_back(to_json(of_engine.back(), parameters));
      }
      if (parts[0].by.empty()) continue;
      judged.push_back(together(engine.id, e, of_engine, parts));
      out << plain(told(judged.back())) << std::flush;
      judgements.push_back(to_json(judged.back()));
    }
  });
  for (const Likelier& pair : likelier(judged)) {
    out << plain(told(pair));
    compared.push_back(to_json(pair));
  }
  ordered_json document = {{"format", "cylon-fit/1"},
                           {"title", whole ? e.title : e.title + " (interrupted: not all is fitted)"},
                           {"source", e.source},
                           {"licence", e.licence},
                           {"instrument", e.instrument},
                           {"known", e.known},
                           {"experiment", e.hash},
                           {"runs", e.runs.size()},
                           {"measured_runs", measured_runs},
                           {"step", e.model.step},
                           {"horizon", e.fit.horizon},
                           {"degrees", number(e.fit.degrees)},
                           {"fits", fits},
                           {"judged", judgements},
                           {"likelier", compared}};
  if (!whole) document["interrupted"] = true;
  if (!options.json.empty())
    write_whole(options.json, document.dump(1, ' ', true, ordered_json::error_handler_t::replace) + "\n");
  if (!whole) {
    show_progress(context.progress, "");
    std::cerr << "interrupted: what is written holds the fits that are done; continue with the same command "
                 "and --resume in this "
                 "folder\n";
    return interrupted;
  }
  return failed ? differs : ok;
}

}  // namespace

Command add_fit(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option("experiment", options->experiment, "File that describes measured motions (docs/measured.md)")
      ->type_name("FILE")
      ->required();
  app.add_option("--parameters", options->parameters,
                 "Those of the file to fit, comma-separated; default: all")
      ->type_name("NAME")
      ->delimiter(',');
  add_engines_option(app, options->engines, "those of the published tables");
  const Option on = app.add_option("--on", options->on,
                                   "Runs to fit: the first or second half by the hashes of their names, "
                                   "judged on the other, or all")
                        ->check(one_of({"first", "second", "all"}))
                        ->capture_default_str();
  app.add_option("--folds", options->folds,
                 "Cross-validation in place of --on: K fits, each judged on the K-th part left out")
      ->type_name("K")
      ->check(in_range(2, 1000))
      ->excludes(on);
  app.add_option("--runs", options->runs,
                 "Only so many runs, the first by the hashes of their names; default: all")
      ->type_name("N")
      ->check(in_range(2, 1'000'000));
  add_step_option(app, options->step);
  app.add_flag("--resume", options->resume,
               "Go on after an interruption: what .cylon/fit.jsonl has is not evaluated again");
  app.add_option("--json", options->json, "Write everything to this file; - is stdout")->type_name("FILE");
  add_jobs_option(app, options->jobs,
                  "Number of windows to predict at the same time; default: all processors");
  add_timeout_option(app, options->timeout);
  add_brought_options(app, options->brought);
  app.footer(
      "Validation: a model is fitted, with its parameters on an engine, and every engine alike. The results "
      "do not\n"
      "depend on the number of jobs. Exit code 1: an engine could not predict a window.");
  return [=, &context] { return fit(context, *options); };
}

}  // namespace cylon::cli
