// cylon run
#include "harness/cli/commands/app.h"
#include "harness/cli/journal.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/provenance.h"
#include "harness/cli/commands/published.h"
#include "harness/cli/scenario_view.h"
#include "harness/cli/selection.h"
#include "harness/cli/traces.h"

#include "harness/core/input_error.h"
#include "harness/study/matrix.h"
#include "reports/console.h"
#include "reports/csv.h"
#include "reports/error_plot.h"
#include "reports/html.h"
#include "reports/json.h"
#include "reports/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;
using results::Verdict;

struct Options {
  Request request;
  std::string json, junit, csv, html, traces, plots;
  Trajectories trajectories = Trajectories::all;
  int jobs = 0;
  double timeout = 60, memory = 4;
  bool rerun_failed = false, resume = false, verbose = false, charts = false;

  bool wants_traces() const { return charts || !html.empty() || !traces.empty() || !plots.empty(); }
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
    if (!as_expected(rows))
      std::cerr << fmt::format("differs: {} on {} at {}\n", cell.scenario->name, cell.engine.id,
                               cell.dt_text);
    std::cerr << fmt::format("\r[{}/{}] {} on {}\x1b[K", finished_, total_, cell.scenario->name,
                             cell.engine.id)
              << std::flush;
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
  const auto broken = [](const Verdict& row) {
    const bool absent = row.status == results::Status::unsupported && row.version.empty();
    return !row.as_expected() &&
           (absent || row.status == results::Status::crash || row.status == results::Status::protocol ||
            row.status == results::Status::timeout);
  };
  if (std::any_of(rows.begin(), rows.end(), broken)) return harness_failure;
  return published_differs || !as_expected(rows) ? differs : ok;
}

// The rows of all cells, in order; of the journal where they are there and still hold.
std::vector<Verdict> run_cells(const Context& context, const Options& options,
                               const scenario::Expectations& expectations, const Journal::Content& last,
                               Journal& journal, const std::vector<study::Cell>& cells) {
  std::vector<std::vector<Verdict>> rows(cells.size());
  std::vector<std::string> keys;
  std::vector<std::size_t> todo;
  std::vector<study::Cell> to_run;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    keys.push_back(cell_key(cells[i], expectations.hash()));
    const auto found = options.resume ? last.cells.find(keys[i]) : last.cells.end();
    if (found != last.cells.end()) {
      rows[i] = found->second;
    } else {
      todo.push_back(i);
      to_run.push_back(cells[i]);
    }
  }
  if (options.resume)
    std::cerr << fmt::format("resumed: {} of {} cells are done already\n", cells.size() - todo.size(),
                             cells.size());

  Progress progress(context.progress, to_run.size());
  const study::Pool pool{.workers = worker_count(options.jobs),
                         .limits = {.run_seconds = options.timeout,
                                    .memory_bytes = static_cast<std::size_t>(options.memory * 1073741824.0)}};
  auto fresh =
      study::run(to_run, pool, expectations, [&](std::size_t i, const std::vector<Verdict>& verdicts) {
        journal.add(keys[todo[i]], to_run[i], verdicts);
        progress.done(to_run[i], verdicts);
      });
  progress.clear();
  for (std::size_t i = 0; i < todo.size(); ++i) rows[todo[i]] = std::move(fresh[i]);
  std::vector<Verdict> flat;
  for (auto& cell : rows) std::move(cell.begin(), cell.end(), std::back_inserter(flat));
  return flat;
}

void print(const Context& context, const Options& options, const std::vector<Verdict>& rows,
           std::size_t cells) {
  const reports::ConsoleOptions style{.width = context.width, .utf8 = context.utf8, .colour = context.colour};
  if (options.verbose || cells == 1) std::cout << reports::console_details(rows, style) << '\n';
  std::cout << reports::console_matrix(rows, style);
}

// What a row needs to come out again, besides the cell: limits that are not the usual ones.
std::string unusual_limits(const Options& options) {
  const Options usual;
  std::string text;
  if (options.timeout != usual.timeout) text += fmt::format(" --timeout {}", options.timeout);
  if (options.memory != usual.memory) text += fmt::format(" --memory {}", options.memory);
  return text;
}

// The page, and the traces beside it for a later page.
void write_report(const Options& options, const Selection& selection, const Traces& traces,
                  const std::vector<Verdict>& rows, const std::string& json) {
  if (options.html.empty() && options.traces.empty()) return;
  reports::HtmlReport report;
  report.results = json;
  for (const auto& scenario : selection.scenarios) report.scenarios.push_back(scenario_view(*scenario));
  report.traces = traces.chosen(selection.cells, rows, options.trajectories, report.omitted_traces);
  if (!options.html.empty()) write_whole(options.html, reports::to_html(report));
  if (options.traces.empty()) return;
  write_whole(options.traces, [&](std::ostream& out) {
    for (const std::string& scenario : report.scenarios) out << scenario << '\n';
    for (const reports::PackedTrace& trace : report.traces) out << reports::to_json_line(trace);
  });
}

// Under each cell's name the errors of its claims over time.
void print_charts(const Traces& traces, const reports::ConsoleOptions& style) {
  for (const reports::Trace& trace : traces.errors()) {
    if (trace.errors.empty()) continue;
    std::cout << reports::shown(fmt::format("{} on {}, {}, dt {}", trace.scenario, trace.engine,
                                            trace.integrator, trace.dt_text),
                                style)
              << "\n\n";
    for (const reports::ErrorCurve& curve : trace.errors)
      std::cout << reports::error_chart(curve, style) << '\n';
  }
}

// A picture per scenario: what the runs that share it are compared in.
void write_plots(const std::string& folder, const Traces& traces) {
  std::map<std::string, std::vector<const reports::Trace*>> by_scenario;
  for (const reports::Trace& trace : traces.errors())
    if (!trace.errors.empty()) by_scenario[trace.scenario].push_back(&trace);
  for (const auto& [scenario, runs] : by_scenario) {
    const reports::Plot plot = reports::error_plot(runs);
    if (!plot.curves.empty())
      write_whole((fs::path(folder) / fmt::format("errors-{}.svg", scenario)).string(),
                  reports::to_svg(plot));
  }
}

int run(const Context& context, const Options& options) {
  const std::vector<std::string> files = {options.json, options.junit, options.csv, options.html,
                                          options.traces};
  require_writable(files);
  if (!options.plots.empty() && !fs::is_directory(options.plots))
    throw core::InputError(fmt::format("--plots {}: no such folder", options.plots));
  const fs::path expected = context.scenarios / "expected.toml";
  const auto expectations =
      fs::exists(expected) ? scenario::Expectations::load(expected) : scenario::Expectations();

  Journal journal(".cylon/journal.jsonl");
  const Journal::Content last = options.resume || options.rerun_failed ? journal.read() : Journal::Content();
  if (options.rerun_failed && !last.request) {
    std::cerr << "nothing to run again: this folder has no earlier run\n";
    return nothing_selected;
  }
  // With nothing said but --resume or --rerun-failed, what the last run was asked for.
  const Request request = last.request && options.request == Request() ? *last.request : options.request;
  Selection selection = select(context, request);
  if (selection.cells.empty()) {
    std::cerr << "nothing selected; see `cylon list --names` and `cylon engines --names`\n";
    return nothing_selected;
  }
  if (options.rerun_failed) {
    std::erase_if(selection.cells,
                  [&](const study::Cell& cell) { return !last.differing.contains(cell_name(cell)); });
    if (selection.cells.empty()) {
      std::cerr << "nothing differed in the last run in this folder\n";
      return nothing_selected;
    }
  }
  for (study::Cell& cell : selection.cells) {
    study::sampling(*cell.scenario, cell.dt);  // refuse a bad step before any run
    cell.reproduce += unusual_limits(options);
  }
  Traces traces;
  if (options.wants_traces()) traces.watch(selection.cells);
  journal.open(request, options.resume);
  std::vector<Verdict> rows;
  try {
    rows = run_cells(context, options, expectations, last, journal, selection.cells);
  } catch (const process::Interrupted&) {
    std::cerr << "interrupted; continue with `cylon run --resume` in this folder\n";
    return interrupted;
  }

  if (!options.plots.empty()) write_plots(options.plots, traces);
  const bool quiet = std::find(files.begin(), files.end(), "-") != files.end();
  if (!quiet && options.charts)
    print_charts(traces, {.width = context.width, .utf8 = context.utf8, .colour = context.colour});
  if (!quiet) print(context, options, rows, selection.cells.size());
  bool published_differs = false;
  if (!selection.suite.published.empty()) {
    const Reproduction reproduction = reproduce(selection.suite, rows);
    published_differs = !reproduction.complete;
    if (!quiet) std::cout << reproduction.text;
  }
  reports::Provenance provenance = provenance_now(context);
  provenance.tolerance_scale = request.tolerance_scale;
  const std::string json = reports::to_json(rows, provenance);
  if (!options.json.empty()) write_whole(options.json, json);
  if (!options.junit.empty()) write_whole(options.junit, reports::to_junit(rows));
  if (!options.csv.empty()) write_whole(options.csv, reports::to_csv(rows));
  write_report(options, selection, traces, rows, json);
  return exit_code(rows, published_differs);
}

}  // namespace

Command add_run(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  Request& request = options->request;
  add_selection_options(app, request);
  app.add_flag("--metamorphic", request.metamorphic,
               "Check symmetries of mechanics instead of the claims: a moved, rotated, mirrored, boosted or "
               "rescaled scene must move alike, and time must be reversible. Needs no exact solution, so it "
               "works for any scene");
  app.add_option("--tolerance-scale", request.tolerance_scale,
                 "Factor on every tolerance; 0 makes every claim fail and so shows every residual. Reports "
                 "mention it")
      ->type_name("X")
      ->capture_default_str()
      ->check(in_range(0.0, 1e300));
  app.add_option("--spread", request.copies,
                 "Add N runs whose initial states differ by one ulp, and report how far they end from the "
                 "first. Default for scenarios tagged chaos: 2")
      ->type_name("N")
      ->check(in_range(1, 1000));
  app.add_option("--json", options->json, "Write the rows as JSON; - is stdout")->type_name("FILE");
  app.add_option("--junit", options->junit, "Write the rows as JUnit XML; - is stdout")->type_name("FILE");
  app.add_option("--csv", options->csv, "Write the rows as CSV; - is stdout")->type_name("FILE");
  app.add_option("--html", options->html, "Write the report as one HTML file; - is stdout")
      ->type_name("FILE");
  app.add_option("--traces", options->traces,
                 "Write the trajectories, for a later `cylon report`; - is stdout")
      ->type_name("FILE");
  app.add_choice(
         "--trajectories", {"none", "fail", "all"},
         [options](const std::string& word) {
           options->trajectories = word == "none"   ? Trajectories::none
                                   : word == "fail" ? Trajectories::fail
                                                    : Trajectories::all;
         },
         "Trajectories in the report: none, fail (scenarios with a failure) or all; failures first, at most "
         "12 MB")
      ->type_name("none|fail|all")
      ->default_str("all");
  app.add_option("--plots", options->plots,
                 "Write a plot of the errors over time for each scenario, errors-SCENARIO.svg")
      ->type_name("FOLDER");
  app.add_flag("--charts", options->charts, "Draw each claim's error over time in the terminal");
  add_jobs_option(app, options->jobs, "Number of cells to run at the same time; default: all processors");
  add_timeout_option(app, options->timeout);
  add_memory_option(app, options->memory);
  const Option rerun =
      app.add_flag("--rerun-failed", options->rerun_failed,
                   "Run only the cells that differed in the last run in this folder (.cylon/journal.jsonl)");
  app.add_flag("--resume", options->resume,
               "Continue the last run in this folder: finished cells are not run again")
      ->excludes(rerun);
  app.add_flag("-v,--verbose", options->verbose,
               "Print every claim of every cell, with the engine's settings");
  return [=, &context] { return run(context, *options); };
}

}  // namespace cylon::cli
