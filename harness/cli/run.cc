// cylon run
#include "harness/cli/app.h"
#include "harness/cli/journal.h"
#include "harness/cli/output.h"
#include "harness/cli/published.h"
#include "harness/cli/selection.h"

#include "harness/core/input_error.h"
#include "harness/study/matrix.h"
#include "reports/console.h"
#include "reports/csv.h"
#include "reports/json.h"
#include "reports/junit.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <iostream>
#include <iterator>
#include <thread>

namespace cylon::cli {
namespace {

using core::Verdict;

struct Options {
  Request request;
  std::string json, junit, csv, command_line;
  std::vector<std::string> workers;
  int jobs = 0;
  double timeout = 60, memory = 4;
  bool rerun_failed = false, resume = false, verbose = false;
};

bool as_expected(const std::vector<Verdict>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const Verdict& row) { return row.as_expected(); });
}

// On one line that is written over, on a terminal; nothing elsewhere.
class Progress {
 public:
  Progress(bool on, std::size_t total) : on_(on), total_(total) {}
  void done(const study::Cell& cell, const std::vector<Verdict>& rows) {
    ++finished_;
    if (!on_) return;
    clear();
    if (!as_expected(rows)) std::cerr << fmt::format("differs: {} on {} at {}\n", cell.scenario->name, cell.engine.id, cell.dt_text);
    std::cerr << fmt::format("\r[{}/{}] {} on {}\x1b[K", finished_, total_, cell.scenario->name, cell.engine.id) << std::flush;
  }
  void clear() const {
    if (on_) std::cerr << "\r\x1b[K" << std::flush;
  }

 private:
  bool on_;
  std::size_t total_, finished_ = 0;
};

int exit_code(const std::vector<Verdict>& rows, bool published_differs) {
  // A worker that could not be had, or that broke where nobody expected it, is the harness's failure; the
  // engine's own misbehaviour is a verdict that differs.
  const bool broken = std::any_of(rows.begin(), rows.end(), [](const Verdict& row) {
    return !row.as_expected() &&
           (row.status == core::Status::crash || row.status == core::Status::protocol || row.status == core::Status::timeout);
  });
  if (broken) return harness_failure;
  return published_differs || !as_expected(rows) ? differs : ok;
}

std::vector<std::vector<Verdict>> run_cells(const Options& options, const scenarios::Expectations& expectations, const std::string& expectations_hash,
                                            const Context& context, std::vector<study::Cell>& cells) {
  Journal journal(".cylon/journal.jsonl");
  const auto stored = options.resume || options.rerun_failed ? journal.read() : decltype(journal.read()){};
  std::vector<std::string> keys;
  for (const study::Cell& cell : cells) keys.push_back(cell_key(cell, expectations_hash));

  if (options.rerun_failed) {
    // Only what differed last time; the key leaves no doubt that it is the same cell, its content may be new.
    std::set<std::string> failed;
    for (const auto& [key, rows] : stored)
      if (!as_expected(rows)) failed.insert(rows.front().scenario + '\n' + rows.front().engine + '\n' + rows.front().dt_text);
    std::erase_if(cells, [&](const study::Cell& cell) {
      return !failed.contains(cell.scenario->name + '\n' + cell.engine.id + '\n' + cell.dt_text);
    });
    keys.clear();
    for (const study::Cell& cell : cells) keys.push_back(cell_key(cell, expectations_hash));
  }

  std::vector<std::vector<Verdict>> rows(cells.size());
  std::vector<std::size_t> todo;
  std::vector<study::Cell> to_run;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto found = options.resume ? stored.find(keys[i]) : stored.end();
    if (found != stored.end()) {
      rows[i] = found->second;
    } else {
      todo.push_back(i);
      to_run.push_back(cells[i]);
    }
  }
  if (options.resume && todo.size() < cells.size())
    std::cerr << fmt::format("resumed: {} of {} cells are done already\n", cells.size() - todo.size(), cells.size());

  journal.open(options.resume);
  Progress progress(context.progress, to_run.size());
  const study::Pool pool{.workers = options.jobs > 0 ? options.jobs : static_cast<int>(std::max(1u, std::thread::hardware_concurrency())),
                         .limits = {.run_seconds = options.timeout,
                                    .memory_bytes = static_cast<std::size_t>(options.memory * 1073741824.0)}};
  auto fresh = study::run(to_run, pool, expectations, [&](std::size_t i, const std::vector<Verdict>& verdicts) {
    journal.add(keys[todo[i]], verdicts);
    progress.done(to_run[i], verdicts);
  });
  progress.clear();
  for (std::size_t i = 0; i < todo.size(); ++i) rows[todo[i]] = std::move(fresh[i]);
  return rows;
}

int run(const Context& context, const Options& options) {
  for (const std::string& file : {options.json, options.junit, options.csv}) require_writable(file);
  const auto engines = with_workers(context, options.workers);
  const auto expectations = scenarios::Expectations::load(context.scenarios / "expected.toml");
  Selection selection = select(context, engines, options.request);
  if (selection.cells.empty()) {
    std::cerr << "nothing selected; `cylon list --names` and `cylon engines --names` say what there is\n";
    return nothing_selected;
  }
  for (const study::Cell& cell : selection.cells) study::sampling(*cell.scenario, cell.dt);  // refuse a bad step before any run

  const auto cells = run_cells(options, expectations, expectations.hash(), context, selection.cells);
  std::vector<Verdict> rows;
  for (const auto& cell : cells) rows.insert(rows.end(), cell.begin(), cell.end());
  if (rows.empty()) {
    std::cerr << "nothing failed last time\n";
    return nothing_selected;
  }

  const bool quiet = options.json == "-" || options.junit == "-" || options.csv == "-";
  bool published_differs = false;
  if (!quiet) {
    const reports::ConsoleOptions style{.width = context.width, .utf8 = context.utf8, .colour = context.colour};
    if (options.verbose || selection.scenarios.size() == 1) std::cout << reports::console_details(rows, style) << '\n';
    std::cout << reports::console_matrix(rows, style);
  }
  if (!options.request.suite.empty() && !selection.suite->published.empty()) {
    const Reproduction reproduction = reproduce(*selection.suite, rows);
    published_differs = !reproduction.complete;
    if (!quiet) std::cout << '\n' << reproduction.text;
  }
  reports::Provenance provenance = reports::build_and_machine();
  provenance.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  provenance.command_line = options.command_line;
  if (!options.json.empty()) write_whole(options.json, reports::to_json(rows, provenance));
  if (!options.junit.empty()) write_whole(options.junit, reports::to_junit(rows));
  if (!options.csv.empty()) write_whole(options.csv, reports::to_csv(rows));
  return exit_code(rows, published_differs);
}

}  // namespace

Command add_run(CLI::App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  Request& request = options->request;
  app.add_option("patterns", request.patterns, "SCENARIO[/ENGINE] globs, several joined by ':', excluded with '-': 'bounce*:-*/ode'; or scenario files")
      ->type_name("GLOB");
  app.add_option("--engine", request.engines, "Engine ids or globs; a variant follows '/': bullet/gyro=none")->type_name("GLOB");
  app.add_option("--dt", request.steps, "Steps [s], 0.001 or 1/60; each scenario's nominal step otherwise")->type_name("S");
  app.add_option("--integrator", request.integrators, "Schemes of the engines")->type_name("GLOB");
  app.add_option("--suite", request.suite, "A suite of scenarios/suites/: its scenarios, engines, steps and published numbers")->type_name("NAME");
  app.add_option("--json", options->json, "Write the rows as JSON; - is stdout")->type_name("FILE");
  app.add_option("--junit", options->junit, "Write the rows as JUnit XML")->type_name("FILE");
  app.add_option("--csv", options->csv, "Write the rows as CSV")->type_name("FILE");
  app.add_option("-j,--jobs", options->jobs, "Cells at one time; all processors otherwise")->type_name("N")->check(CLI::PositiveNumber);
  app.add_option("--timeout", options->timeout, "Seconds until an engine is stopped, for each run")->capture_default_str()->type_name("S")->check(CLI::PositiveNumber);
  app.add_option("--memory", options->memory, "Limit of an engine's memory [GiB]")->capture_default_str()->type_name("GIB")->check(CLI::PositiveNumber);
  app.add_flag("--rerun-failed", options->rerun_failed, "Only the cells that differed in the last run in this folder");
  app.add_flag("--resume", options->resume, "Go on with the last run in this folder: cells that are done are not run again");
  app.add_flag("-v,--verbose", options->verbose, "Every claim of every cell, not only the matrix");
  add_worker_option(app, options->workers);
  return [=, &context] { return run(context, *options); };
}

}  // namespace cylon::cli
