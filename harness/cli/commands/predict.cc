// cylon predict
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/commands/drawing_json.h"
#include "harness/cli/commands/estimates.h"
#include "harness/cli/commands/fitted_values.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/progress.h"
#include "harness/cli/read_whole.h"
#include "harness/cli/workers.h"
#include "harness/core/input_error.h"
#include "harness/input/json.h"
#include "harness/process/client.h"
#include "harness/process/engine_table.h"
#include "harness/process/interruption.h"
#include "harness/study/parallel.h"
#include "harness/study/session_runner.h"
#include "harness/validation/length_scale.h"
#include "harness/validation/score.h"
#include "harness/validation/split.h"
#include "harness/validation/synthetic.h"
#include "reports/html.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>

namespace cylon::cli {
namespace {

using nlohmann::ordered_json;
using validation::Estimate, validation::Horizon, validation::RunScore;

constexpr int not_said = -1, usual_curves = 3;

struct Options {
  std::string experiment, json, html, step, fit, synthetic;
  std::vector<std::string> engines, values;
  Brought brought;
  validation::Band band;
  int jobs = 0, runs = 0, curves = not_said;
  double timeout = 60;
};

// What is told in words goes where no document goes.
std::ostream& words(const Options& options) {
  return options.json == "-" || options.html == "-" ? std::cerr : std::cout;
}

// What is predicted, and with what.
struct Task {
  measured::Experiment experiment;
  std::vector<FoundFit> fits;  // none: the model's own values
  std::vector<process::EngineChoice> engines;
  std::vector<std::size_t> runs, drawn;  // by their places in the table
};

// Of a run with a fit that did not see it, where there are fits.
template <class Score, class One>
Score with_fit_of(const Task& task, const process::EngineChoice& engine, std::size_t run, const One& one) {
  if (task.fits.empty()) return one(validation::Fitted{});
  const FoundFit* fit = unseen(task.fits, engine.id, task.experiment.runs[run]);
  if (fit && fit->failure.empty()) return one(fit->fitted);
  Score none;
  none.run = task.experiment.runs[run].name,
  none.failure = fit ? "no fit: " + fit->failure : "every fit of this engine saw the run";
  return none;
}

template <class Score, class One>
std::vector<Score> of_runs(const Context& context, const Options& options, const Task& task,
                           const process::EngineChoice& engine, const std::vector<std::size_t>& runs,
                           const One& one) {
  const study::Runner runner = study::session_runner(engine, {.run_seconds = options.timeout});
  std::vector<Score> all(runs.size());
  std::mutex guard;
  std::size_t done = 0;
  study::in_parallel(runs.size(), worker_count(options.jobs), [&](std::size_t i) {
    all[i] = with_fit_of<Score>(task, engine, runs[i], [&](const validation::Fitted& fitted) {
      return one(task.experiment, runs[i], runner, options.band, fitted);
    });
    const std::scoped_lock lock(guard);
    ++done;
    show_progress(context.progress, fmt::format("{}: {} of {} runs", engine.id, done, runs.size()));
  });
  show_progress(context.progress, "");
  return all;
}

std::string told_length(const char* what, const Estimate& scale, const std::string& means) {
  if (!std::isfinite(scale.interval.low))
    return fmt::format("  {:<22} {} ({} runs, too few for an interval)\n", what, shown(scale, 1, "", 4),
                       scale.runs);
  const auto answer = validation::answer({1, 1}, scale.interval.low, scale.interval.high);
  return fmt::format("  {:<22} {:.4f} [{:.4f}, {:.4f}] of {} ({} runs){}\n", what, scale.value,
                     scale.interval.low, scale.interval.high, means, scale.runs,
                     answer == validation::Answer::inside ? "" : ": 1 is outside the interval");
}

void tell_lengths(const Options& options, const measured::Experiment& e) {
  const validation::LengthScale lengths = validation::length_scale(e);
  words(options) << "Lengths of the data, measured/true, with 95 % intervals:\n"
                 << told_length("from free flight", lengths.flight,
                                fmt::format("the fall of {:.4g} m/s^2", lengths.gravity))
                 << told_length(
                        "from heights at rest", lengths.rest,
                        fmt::format("the height; centres lie {} up", shown(lengths.height, 1000, " mm", 2)));
  if (std::isfinite(lengths.tilt))
    words(options) << fmt::format("  tilt at rest           {:.1f} mrad, root mean square\n",
                                  1000 * lengths.tilt);
}

template <class Score>
ordered_json each(const std::vector<Score>& runs) {
  ordered_json all = ordered_json::array();
  for (const Score& run : runs) all.push_back(to_json(run));
  return all;
}

ordered_json drawn(const Context& context, const Options& options, const Task& task,
                   const process::EngineChoice& engine) {
  if (options.json.empty() && options.html.empty()) return ordered_json::array();
  return each(of_runs<validation::Drawing>(context, options, task, engine, task.drawn, validation::drawing));
}

// The scores of an engine, printed; and as JSON.
template <class Score>
ordered_json told_engine(const Context& context, const Options& options, const Task& task,
                         const process::EngineChoice& engine, const std::vector<Score>& scores) {
  auto summary = validation::summary(scores);
  if (!validation::judged(options.band.members)) summary.band = validation::Answer::undecided;
  words(options) << plain(engine.id + "\n" + told(summary, options.band.members)) << std::flush;
  ordered_json one = to_json(summary);
  one["engine"] = engine.id, one["each"] = each(scores);
  one["drawn"] = drawn(context, options, task, engine);
  return one;
}

ordered_json told_nearer(const Options& options, const Task& task,
                         const std::vector<std::vector<RunScore>>& all) {
  ordered_json compared = ordered_json::array();
  const auto pairs = validation::nearer(all);
  for (std::size_t j = 0; j < pairs.size(); ++j) {
    const auto& [one, other, p, answer] = pairs[j];
    const std::string &first = task.engines[0].id, &second = task.engines[j + 1].id;
    const std::string nearest = answer == validation::Answer::inside    ? first
                                : answer == validation::Answer::outside ? second
                                                                        : "undecided";
    if (one == 0 && other == 0) {
      words(options) << plain_line(fmt::format(
                            "nearer at rest: {} and {} predicted no run alike: not compared", first, second))
                     << '\n';
      continue;
    }
    words(options) << plain_line(fmt::format("nearer at rest: {} in {} runs, {} in {}: {} (p = {:.2g}, Holm)",
                                             first, one, second, other, nearest, p))
                   << '\n';
    compared.push_back({{"one", first},
                        {"other", second},
                        {"runs_of_one", one},
                        {"runs_of_other", other},
                        {"p", p},
                        {"nearer", nearest}});
  }
  return compared;
}

ordered_json predicted(const Context& context, const Options& options, const Task& task) {
  const measured::Experiment& e = task.experiment;
  ordered_json document = {{"format", "cylon-prediction/1"},
                           {"title", e.title},
                           {"source", e.source},
                           {"licence", e.licence},
                           {"instrument", e.instrument},
                           {"known", e.known},
                           {"experiment", e.hash},
                           {"model", e.model.hash},
                           {"coordinates", e.coordinates == measured::Coordinates::free ? "free" : "chain"},
                           {"step", e.model.step},
                           {"rate", e.rate},
                           {"measured_runs", e.runs.size()},
                           {"set", options.values},
                           {"fitted", !task.fits.empty()},
                           {"members", options.band.members},
                           {"seed", options.band.seed},
                           {"discrepancy", options.band.discrepancy},
                           {"synthetic", options.synthetic},
                           {"kinematics", kinematics_json(e)},
                           {"drawn", measured_json(e, task.drawn)},
                           {"engines", ordered_json::array()}};
  // Where it is interrupted the document says so, and holds the engines that are done.
  const auto of_engines = [&](const auto& one) {
    const bool whole = process::completes([&] {
      for (const process::EngineChoice& engine : task.engines) document["engines"].push_back(one(engine));
    });
    if (whole) return true;
    document["title"] = e.title + " (interrupted: not all is predicted)";
    document["interrupted"] = true;
    return false;
  };
  if (e.coordinates == measured::Coordinates::chain) {
    const auto one = [](const auto&... of) { return validation::horizon(of...); };
    of_engines([&](const process::EngineChoice& engine) {
      return told_engine(context, options, task, engine,
                         of_runs<Horizon>(context, options, task, engine, task.runs, one));
    });
    return document;
  }
  std::vector<std::vector<RunScore>> all;
  const bool whole = of_engines([&](const process::EngineChoice& engine) {
    all.push_back(of_runs<RunScore>(context, options, task, engine, task.runs, validation::score));
    return told_engine(context, options, task, engine, all.back());
  });
  document["lengths"] = lengths_json(e), document["touches"] = touches_json(e);
  document["nearer"] = whole ? told_nearer(options, task, all) : ordered_json::array();
  return document;
}

// The experiment with data that an engine made of it.
measured::Experiment made_by(const process::EngineChoice& engine, const Options& options,
                             measured::Experiment e) {
  std::vector<std::size_t> runs(e.runs.size());
  std::iota(runs.begin(), runs.end(), 0);
  e.parameters.clear();  // the values of the model are the truth
  try {
    return validation::synthetic(e, runs, {}, study::session_runner(engine, {.run_seconds = options.timeout}),
                                 options.band.seed, validation::Surfaces::drawn);
  } catch (const study::RunFailed& failed) {
    throw core::InputError(fmt::format("--synthetic {}: {}", engine.id, failed.outcome.reason));
  }
}

Task task_of(const Context& context, const Options& options) {
  Task task;
  task.experiment = measured::read(options.experiment);
  measured::Experiment& e = task.experiment;
  set_step(e, options.step);
  e = first_runs(e, options.runs);
  e = set_values(e, options.values);
  if (!options.fit.empty()) task.fits = read_fits(options.fit, e, options.band.members > 0);
  if (options.band.discrepancy && !std::isfinite(e.fit.degrees))
    throw core::InputError(fmt::format("--discrepancy: {}: [fit] states no degrees", e.file));
  const auto rows = with_brought(context, options.brought);
  if (!options.synthetic.empty()) e = made_by(process::parse_engine(options.synthetic, rows), options, e);
  const std::vector<std::string> ids = !options.engines.empty() ? options.engines
                                       : task.fits.empty()      ? process::compared_engines()
                                                                : engines_of(task.fits);
  const std::vector<std::string> fitted = engines_of(task.fits);
  for (const std::string& id : ids) {
    task.engines.push_back(process::parse_engine(id, rows));
    process::require_possible(task.engines.back());
    if (!task.fits.empty() && std::ranges::find(fitted, task.engines.back().id) == fitted.end())
      throw core::InputError(fmt::format("{}: it has no fit of {}", options.fit, task.engines.back().id));
  }
  const int curves = options.curves == not_said ? usual_curves : options.curves;
  for (const std::size_t run : validation::order_of(e)) {
    if (!task.fits.empty() && std::ranges::none_of(task.engines, [&](const process::EngineChoice& engine) {
          return unseen(task.fits, engine.id, e.runs[run]);
        }))
      continue;
    task.runs.push_back(run);
    if (task.drawn.size() < static_cast<std::size_t>(curves)) task.drawn.push_back(run);
  }
  if (task.runs.empty())
    throw core::InputError(fmt::format("{}: its fits saw every run of {}: none is left to predict",
                                       options.fit, options.experiment));
  std::ranges::sort(task.runs);
  return task;
}

void write_page(const Options& options, const ordered_json& document) {
  reports::HtmlReport report;
  report.title = document["title"];
  report.documents["predictions"] = {document};
  if (!options.fit.empty())
    report.documents["fits"] = {
        input::parse_json<ordered_json>(read_whole(options.fit, std::size_t{64} << 20))};
  write_whole(options.html, reports::to_html(std::move(report)));
}

int predict(const Context& context, const Options& options) {
  require_writable(std::vector<std::string>{options.json, options.html});
  if (options.curves != not_said && options.json.empty() && options.html.empty())
    throw core::InputError("--curves: nothing holds curves; give --json or --html");
  const Task task = task_of(context, options);
  const measured::Experiment& e = task.experiment;
  words(options) << plain_line(fmt::format("{}: {} runs", e.title, e.runs.size())) << '\n';
  for (const std::string& known : e.known)
    words(options) << plain_line(fmt::format("  known: {}", known)) << '\n';
  for (const std::string& value : options.values)
    words(options) << plain_line(fmt::format("  set: {}", value)) << '\n';
  if (!options.synthetic.empty())
    words(options) << plain_line(fmt::format("  synthetic: made by {} with the stated errors, seed {}",
                                             options.synthetic, options.band.seed))
                   << '\n';
  words(options) << told_kinematics(e);
  if (e.coordinates == measured::Coordinates::free) {
    tell_lengths(options, e);
    words(options) << told_touches(e);
  }
  if (options.band.discrepancy && options.band.members > 0)
    words(options) << fmt::format(
        "The band has the model's discrepancy of {:g} degrees of freedom: each member's errors have a factor "
        "of "
        "their own\n",
        e.fit.degrees);
  if (!task.fits.empty())
    words(options) << plain_line(fmt::format("Parameters of {}: {} runs that it did not see", options.fit,
                                             task.runs.size()))
                   << '\n';
  words(options) << fmt::format(
      "Predictions from the first frame, steps of {} s; medians over runs, with 95 % intervals:\n",
      options.step.empty() ? e.model.step_text : options.step);
  const process::Interruptible until_told;
  const ordered_json document = predicted(context, options, task);
  if (!options.json.empty())
    write_whole(options.json, document.dump(1, ' ', true, ordered_json::error_handler_t::replace) + '\n');
  if (!options.html.empty()) write_page(options, document);
  if (!document.contains("interrupted")) return ok;
  show_progress(context.progress, "");
  std::cerr << "interrupted: what is written holds the engines that are done\n";
  return interrupted;
}

}  // namespace

Command add_predict(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option("experiment", options->experiment, "File that describes measured motions (docs/measured.md)")
      ->type_name("FILE")
      ->required();
  add_engines_option(app, options->engines, "those of the published tables, or of --fit");
  add_step_option(app, options->step);
  const Option set =
      app.add_option("--set", options->values, "Parameter of the file with a value; may be given again")
          ->type_name("NAME=VALUE")
          ->allow_extra_args(false);
  app.add_option(
         "--fit", options->fit,
         "File of cylon fit --json: predicts the runs that a fit did not see, with its parameters; the "
         "band has their covariance")
      ->type_name("FILE")
      ->excludes(set);
  app.add_option("--runs", options->runs,
                 "Only so many runs, the first by the hashes of their names; default: all")
      ->type_name("N")
      ->check(in_range(1, 1'000'000));
  app.add_option(
         "--members", options->band.members,
         "Predictions of the band of each run, from uncertain starts, materials and fitted parameters; "
         "39 make 95 %, 0 none. Whether the band holds what it should is judged for 39 alone")
      ->type_name("N")
      ->check(in_range(0, 10'000))
      ->capture_default_str();
  app.add_option("--seed", options->band.seed, "Of the band and of --synthetic")
      ->type_name("S")
      ->check(whole(std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  app.add_flag(
      "--discrepancy", options->band.discrepancy,
      "The band has the model's discrepancy of [fit] degrees, as fits do: a factor of all errors, for each "
      "member its own");
  app.add_option("--synthetic", options->synthetic,
                 "Predicts in place of the data what this engine makes of the model with the stated errors, "
                 "by --seed: "
                 "the truth is known then")
      ->type_name("ENGINE");
  app.add_option("--json", options->json, "Write everything, run by run, to this file; - is stdout")
      ->type_name("FILE");
  app.add_option("--html", options->html, "Write the page of the data set as one HTML file; - is stdout")
      ->type_name("FILE");
  app.add_option("--curves", options->curves,
                 "Runs whose curves --json and --html hold: the first by the hashes of their names")
      ->type_name("N")
      ->check(in_range(0, 1000))
      ->default_str(std::to_string(usual_curves));
  add_jobs_option(app, options->jobs, "Number of runs to predict at the same time; default: all processors");
  add_timeout_option(app, options->timeout);
  add_brought_options(app, options->brought);
  app.footer(
      "Validation: what is judged is the model with its parameters on an engine, never an engine alone. The "
      "results\n"
      "do not depend on the number of jobs.");
  return [=, &context] { return predict(context, *options); };
}

}  // namespace cylon::cli
