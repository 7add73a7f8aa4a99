// cylon track record
#include "harness/cli/command_line.h"
#include "harness/cli/content_of.h"
#include "harness/cli/journal.h"
#include "harness/cli/options.h"
#include "harness/cli/selection.h"
#include "harness/tracking/run_lock.h"
#include "harness/tracking/run_words.h"
#include "harness/tracking/track.h"
#include "harness/tracking/track_anchor.h"
#include "harness/tracking/track_result.h"
#include "harness/tracking/track_times.h"

#include "harness/core/content_hash.h"
#include "harness/input/json.h"
#include "harness/process/interruption.h"
#include "harness/process/sandbox.h"
#include "harness/results/duration.h"
#include "harness/study/cell_pool.h"
#include "harness/study/instructions.h"
#include "harness/study/side.h"
#include "reports/text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <limits>
#include <map>
#include <utility>

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

namespace {

using results::Verdict;
using store::Kind;
using store::Store;

// What is measured of each cell; an interrupted recording goes on with the same.
struct Measured {
  int repetitions = 5;
  bool orders = false;
  std::string instructions = "off";
  double timeout = 60, memory = 4;
};

struct Options {
  Request request;
  Measured measured;
  RunWords words;
  std::string store;
  int jobs = 1;
  bool resume = false, verbose = false;
};

nlohmann::json to_json(const Request& request, const Measured& m) {
  nlohmann::json j = {{"request", to_json(request)},    {"repetitions", m.repetitions}, {"orders", m.orders},
                      {"instructions", m.instructions}, {"timeout", m.timeout},         {"memory", m.memory}};
  if (process::sandboxing()) j["sandbox"] = true;
  return j;
}

void restore(const std::string& text, Options& options) {
  const auto j = input::parse_json(text);
  if (j.value("sandbox", false)) process::require_sandbox_again("this recording was begun");
  options.request = request_from(j.at("request"));
  options.measured = {j.at("repetitions"), j.at("orders"), j.at("instructions"), j.at("timeout"),
                      j.at("memory")};
}

std::string build_of(const std::vector<study::Cell>& cells) {
  std::map<std::string, std::string> hashes;
  for (const study::Cell& cell : cells)
    if (auto& hash = hashes[cell.engine.row.id]; hash.empty())
      hash = study::content_hash(cell.engine.row.command);
  core::ContentHash content;
  for (const auto& [engine, hash] : hashes) content.add(fmt::format("{}={};", engine, hash));
  return content.hex();
}

// The last run that did not reach its end.
store::RunInfo unfinished(const Store& store, const Options& options) {
  std::vector<store::RunInfo> runs = store.runs();
  std::erase_if(runs, [](const store::RunInfo& run) { return run.complete || run.request.empty(); });
  if (runs.empty())
    throw core::InputError(options.store, 0, 0, "every recording is complete: there is nothing to resume");
  return *std::max_element(runs.begin(), runs.end(),
                           [](const auto& a, const auto& b) { return a.id < b.id; });
}

std::string asked_key(const study::Cell& cell, const std::string& expectations) {
  core::ContentHash content;
  content.add(
      cell_key(cell, expectations, content_of(cell.engine.row.command)));  // build_of() knows the rest
  return content.hex();
}

// Exact where nothing but the engine's steps is counted.
void count_instructions(const study::Cell& cell, const Measured& measured, const process::Limits& limits,
                        std::vector<store::Sample>& samples) {
  if (measured.instructions == "off") return;
  const auto counter = measured.instructions == "auto" ? study::find_counter().counter
                                                       : study::counter_from(measured.instructions).value();
  const study::Sampling sampling = study::sampling(*cell.scenario, cell.dt);
  study::InstructionRequest request;
  request.scene = &cell.scenario->scene;
  request.dt = cell.dt;
  request.steps = study::steps_to_count(cell.scenario->scene.bodies.size(), sampling.steps);
  request.every = sampling.every;
  const study::InstructionCount count = study::count_instructions(cell.engine, request, limits, counter);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  if (count.instructions)
    samples.push_back({{fmt::format("instructions:{}", study::name(count.counter)),
                        count.steps_alone ? Kind::exact : Kind::size, ""},
                       0,
                       static_cast<double>(*count.instructions),
                       ""});
  else
    samples.push_back({{"no_instructions", Kind::info, ""}, 0, nan, count.remark});
}

// Runs the cells that the run lacks; each is in the store when its line is told.
class Recorder {
 public:
  Recorder(const Context& context, const Options& options, Store& store, std::int64_t run,
           std::vector<PinnedEngine> anchors)
      : context_(context), options_(options), store_(store), run_(run), anchors_(std::move(anchors)) {
    limits_.run_seconds = options.measured.timeout;
    limits_.memory_bytes = static_cast<std::size_t>(options.measured.memory * 1073741824.0);
    expectations_ = cli::expectations(context);
  }

  void record(const std::vector<study::Cell>& cells) {
    const std::set<std::string> done = store_.asked(run_);
    std::vector<study::Cell> todo;
    for (const study::Cell& cell : cells)
      if (!done.contains(asked_key(cell, expectations_.hash()))) todo.push_back(cell);
    if (options_.resume)
      std::cerr << fmt::format("resumed: {} of {} cells are there already\n", cells.size() - todo.size(),
                               cells.size());
    std::vector<process::RunOutcome> outcomes(todo.size());
    for (std::size_t i = 0; i < todo.size(); ++i)
      todo[i].seen = [&outcomes, i](const process::RunOutcome& outcome, auto) { outcomes[i] = outcome; };
    std::size_t finished = 0;
    const study::Matrix matrix = study::run(
        todo, {options_.jobs, limits_}, expectations_, [&](std::size_t i, const auto& rows, double) {
          add(todo[i], outcomes[i], rows);
          outcomes[i] = {};
          if (options_.verbose)
            std::cout << plain_line(fmt::format("stored {} on {} at {}", todo[i].scenario->name,
                                                todo[i].engine.id, results::step_in_words(todo[i].dt_text)))
                      << std::endl;
          if (context_.progress)
            std::cerr << fmt::format("\r[{}/{}] {}\x1b[K", ++finished, todo.size(),
                                     plain_line(todo[i].scenario->name + " on " + todo[i].engine.id))
                      << std::flush;
        });
    if (context_.progress) std::cerr << "\r\x1b[K" << std::flush;
    for (const auto& list : {matrix.refused, matrix.failed})
      for (const std::string& line : list) std::cerr << "error: " << plain_line(line) << '\n';
    if (matrix.interrupted) throw process::Interrupted();
    refused_ = !matrix.refused.empty();
    failed_ = !matrix.failed.empty();
  }

  std::size_t differing() const { return differing_; }
  bool engine_absent() const { return absent_; }
  bool refused() const { return refused_; }  ///< An engine called what it was asked impossible.
  bool failed() const { return failed_; }    ///< Cells are missing, because the harness failed in them.

 private:
  void add(const study::Cell& cell, const process::RunOutcome& outcome, const std::vector<Verdict>& rows) {
    store::Result result = result_of(cell, outcome, rows);
    result.asked = asked_key(cell, expectations_.hash());
    if (outcome.recording) {
      const auto append = [&](std::vector<store::Sample> samples) {
        std::move(samples.begin(), samples.end(), std::back_inserter(result.samples));
      };
      append(time_samples(cell, outcome, options_.measured.repetitions, anchors_, limits_));
      if (options_.measured.orders) append(observed_orders(cell, rows, at_half_the_step(cell)));
      count_instructions(cell, options_.measured, limits_, result.samples);
    }
    store_.add(run_, result);
    absent_ = absent_ || (!outcome.recording && outcome.engine.version.empty());
    differing_ +=
        !std::all_of(rows.begin(), rows.end(), [](const Verdict& row) { return row.as_expected(); });
  }

  std::vector<Verdict> at_half_the_step(study::Cell cell) const {
    cell.dt /= 2;
    cell.seen = {};
    return study::run(cell, limits_, expectations_);
  }

  const Context& context_;
  const Options& options_;
  Store& store_;
  std::int64_t run_;
  std::vector<PinnedEngine> anchors_;
  process::Limits limits_;
  scenario::Expectations expectations_;
  std::size_t differing_ = 0;
  bool absent_ = false, refused_ = false, failed_ = false;
};

int record(const Context& context, Options options) {
  if (options.resume && options.request != Request())
    throw core::InputError("--resume continues with the earlier selection: do not give a new one");
  RunLock lock(options.store);
  std::optional<Store> store;
  store::RunInfo run;
  if (options.resume) {
    Store::open(options.store, store::Mode::read);  // which must be there
    store.emplace(Store::open(options.store, store::Mode::write));
    run = unfinished(*store, options);
    // What it asks for may name programs.
    if (!store->is_own(run))
      throw core::InputError(
          options.store, 0, 0,
          fmt::format(
              "run {} was imported, or begun by somebody else: it cannot be resumed here; start a new one "
              "without --resume",
              run.id));
    restore(run.request, options);
  }
  const Selection selection = select(context, options.request);
  if (selection.cells.empty()) {
    std::cerr << "nothing selected; see `cylon list --names` and `cylon engines --names`\n";
    return nothing_selected;
  }
  for (const study::Cell& cell : selection.cells) study::sampling(*cell.scenario, cell.dt);
  const std::string build = build_of(selection.cells);
  if (options.resume && build != run.build)
    throw core::InputError(
        fmt::format("the engine binaries have changed since the interrupted recording of {}; start a new one "
                    "without --resume",
                    run.date));
  if (!store) store.emplace(Store::open(options.store, store::Mode::write));
  std::vector<PinnedEngine> anchors =
      pinned_engines(*store, options.store);  // refused before anything is begun
  if (!options.resume) {
    run = run_here(context, options.words);
    run.build = build;
    run.request = to_json(options.request, options.measured).dump(-1, ' ', true);
    run.id = store->begin_run(run);
  }
  lock.hold(*store, run.id);
  Recorder recorder(context, options, *store, run.id, std::move(anchors));
  const process::Interruptible until_told;
  try {
    recorder.record(selection.cells);
  } catch (const process::Interrupted&) {
    std::cerr << fmt::format("interrupted; continue with `{} track record --resume`\n",
                             shell_command(program_words()));
    return interrupted;
  }
  if (recorder.failed()) {
    std::cerr << fmt::format("cells are missing; continue with `{} track record --resume`\n",
                             shell_command(program_words()));
    return harness_failure;
  }
  store->finish_run(run.id);
  std::cout << fmt::format("{}: run {} of {}, {}{}\n", options.store, run.id,
                           run.revision.empty() ? "no revision" : plain_line(run.revision),
                           reports::counted(selection.cells.size(), "cell"),
                           recorder.differing() == 0
                               ? ""
                               : fmt::format(", {} of them differ from expected.toml", recorder.differing()));
  if (recorder.refused()) return bad_input;
  return recorder.engine_absent() ? harness_failure : ok;
}

}  // namespace

Command add_track_record(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  Measured& measured = options->measured;
  add_selection_options(app, options->request);
  add_run_options(app, options->words);
  app.add_option("--repetitions", measured.repetitions,
                 "Number of timings of each cell, each in a new process; 0: no timing")
      ->type_name("K")
      ->check(in_range(0, 1000))
      ->capture_default_str();
  app.add_flag("--orders", measured.orders,
               "Run at half the step too, and record the observed order of each claim");
  app.add_option(
         "--instructions", measured.instructions,
         "Count the instructions of the engine's steps: auto is perf_event where it opens, else callgrind, "
         "which takes some 40 times as long")
      ->check(one_of({"off", "auto", "perf_event", "callgrind"}))
      ->capture_default_str();
  add_timeout_option(app, measured.timeout);
  add_memory_option(app, measured.memory);
  add_jobs_option(app, options->jobs,
                  "Number of cells to run at the same time; more than one disturbs the times")
      ->capture_default_str();
  app.add_flag("--resume", options->resume, "Continue the last interrupted recording of the store");
  app.add_flag("-v,--verbose", options->verbose, "Print a line for each stored cell");
  add_store_option(app, options->store);
  app.footer(
      "Each cell is stored as soon as it is measured; --resume continues an interrupted recording after the "
      "last one. Verdicts are stored, not judged: exits 0 when everything is recorded, 5 when an engine is "
      "not there.");
  return [options, &context] { return record(context, *options); };
}

}  // namespace cylon::tracking
