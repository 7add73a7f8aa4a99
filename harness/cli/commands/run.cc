// cylon run
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/commands/run_cells.h"
#include "harness/cli/commands/run_options.h"
#include "harness/cli/commands/run_output.h"
#include "harness/cli/journal.h"
#include "harness/cli/output.h"
#include "harness/cli/provenance_now.h"
#include "harness/core/input_error.h"
#include "harness/process/interruption.h"
#include "reports/csv.h"
#include "reports/json.h"
#include "reports/junit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <set>
#include <string>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;
using results::Verdict;

// Motions are seen by the process that runs them; a farm's leader gets verdicts.
void refuse_in_farm(const Context& context, const RunOptions& options) {
  if (context.farm &&
      (options.charts || !options.html.empty() || !options.traces.empty() || !options.plots.empty()))
    throw core::InputError(
        "--html, --traces, --plots and --charts: a farm keeps verdicts and no motions; write --json, and "
        "`cylon report` "
        "makes the page of it");
}

// Only scenes with a table [theory] can be asked by theory.
void leave_out_without_theory(Selection& selection) {
  std::set<std::string> without;
  std::erase_if(selection.cells, [&](const study::Cell& cell) {
    if (cell.scenario->theory) return false;
    without.insert(cell.scenario->name);
    return true;
  });
  if (!without.empty())
    std::cerr << plain_line(fmt::format("warning: --theory leaves out what has no table [theory]: {}",
                                        fmt::join(without, ", ")))
              << '\n';
}

// What a rank has to say: what its journal does not.
int of_a_rank(const study::Matrix& matrix, const Journal& journal) {
  for (const auto& list : {matrix.refused, matrix.failed})
    for (const std::string& line : list) std::cerr << "error: " << plain_line(line) << '\n';
  if (matrix.interrupted) return interrupted;
  return !journal.is_open() ? harness_failure : matrix.refused.empty() ? ok : bad_input;
}

// Says which scenarios claim nothing; whether they are all.
bool claims_nothing(const std::vector<study::Cell>& cells) {
  std::set<std::string> silent;
  bool any = false;
  for (const study::Cell& cell : cells) {
    if (cell.exam != study::Exam::claims || !cell.scenario->claims.empty())
      any = true;
    else
      silent.insert(cell.scenario->name);
  }
  for (const std::string& name : silent)
    std::cerr << plain_line(fmt::format("{} claims nothing: nothing of it is judged", name)) << '\n';
  return !any;
}

int run(const Context& context, const RunOptions& options) {
  refuse_in_farm(context, options);
  const std::vector<std::string> files = {options.json, options.junit, options.csv, options.html,
                                          options.traces};
  require_writable(files);
  if (options.trajectories != Trajectories::all && options.html.empty() && options.traces.empty())
    throw core::InputError("--trajectories: nothing holds trajectories; give --html or --traces");
  if (std::error_code error; !options.plots.empty() && !fs::is_directory(options.plots) &&
                             !fs::create_directories(options.plots, error))
    throw core::InputError(fmt::format("--plots {}: {}", options.plots,
                                       fs::exists(options.plots) ? "is no folder" : error.message()));
  const scenario::Expectations expectations = cli::expectations(context);

  const std::optional<Shard> shard = shard_asked(options.shard, context.farm);
  if (shard && options.rerun_failed)
    throw core::InputError(fmt::format("--rerun-failed: not of a shard ({})", shard->said_by));
  Journal journal(journal_file("run", shard));
  const bool looks_back = (options.resume && !context.farm) || options.rerun_failed;
  const Journal::Content last = looks_back ? journal.read() : Journal::Content();
  if (options.rerun_failed && !last.request) {
    std::cerr << "nothing to run again: this folder has no earlier run\n";
    return nothing_selected;
  }
  if (last.strange > 0)
    std::cerr << fmt::format(
        "{} lines of {} are cut off, or were not written by you in this folder; they are not used\n",
        last.strange, journal_file("run", shard).string());
  if (options.resume && !last.request && last.strange > 0 && options.request == Request())
    throw core::InputError("--resume: this folder has no run of yours; say what to run");
  // With nothing said but --resume or --rerun-failed, what the last run was asked for.
  const Request request = last.request && options.request == Request() ? *last.request : options.request;
  Selection selection = select_unprepared(context, request);
  if (request.theory) leave_out_without_theory(selection);
  if (selection.cells.empty()) {
    std::cerr << "nothing selected; see `cylon list --names` and `cylon engines --names`\n";
    return nothing_selected;
  }
  if (options.rerun_failed) {
    std::erase_if(selection.cells,
                  [&](const study::Cell& cell) { return !last.differing.contains(cell_name(cell)); });
    if (selection.cells.empty()) {
      std::cerr << "of the cells that ran in this folder, none differed\n";
      return nothing_selected;
    }
  }
  const Part part{"run", shard ? shard->index : 1, shard ? shard->count : 1,
                  units_of(selection.cells, expectations.hash()), request.suite};
  keep(own_units(shard, part, options.resume), selection.cells);
  prepare(selection);
  if (!shard && claims_nothing(selection.cells)) return nothing_selected;
  for (study::Cell& cell : selection.cells) {
    study::sampling(*cell.scenario, cell.dt);  // refuse a bad step before any run
    cell.reproduce += unusual_limits(options);
  }
  Traces traces;
  if (options.wants_traces()) traces.watch(selection.cells);
  journal.open(request, part, options.resume);
  if (shard && !journal.is_open())
    throw core::InputError("a shard is its journal, and there is none: nothing was run");
  const process::Interruptible until_told;
  study::Matrix matrix = run_cells(context, options, expectations, last, journal, selection.cells, shard);
  if (shard && shard->farm) return of_a_rank(matrix, journal);
  std::vector<Verdict> rows;
  for (auto& cell : matrix.rows) std::move(cell.begin(), cell.end(), std::back_inserter(rows));

  if (!options.plots.empty()) write_plots(options.plots, traces);
  const bool quiet = std::find(files.begin(), files.end(), "-") != files.end();
  if (!quiet && options.charts)
    print_charts(traces, {.width = context.width, .utf8 = context.utf8, .colour = context.colour});
  if (!quiet) print(context, options, rows, selection.cells.size());
  // A part of the rows reproduces no table.
  const bool published_differs = !shard && print_published(selection.suite, rows, quiet);
  reports::Provenance provenance = provenance_now(context);
  provenance.tolerance_scale = request.tolerance_scale;
  if (!options.json.empty()) write_whole(options.json, reports::to_json(rows, provenance));
  if (!options.junit.empty()) write_whole(options.junit, reports::to_junit(rows));
  if (!options.csv.empty()) write_whole(options.csv, reports::to_csv(rows));
  write_report(options, selection, traces, {provenance, rows});
  for (const auto& list : {matrix.refused, matrix.failed})
    for (const std::string& line : list) std::cerr << "error: " << plain_line(line) << '\n';
  if (matrix.interrupted)
    std::cerr << fmt::format(
        "interrupted: the reports hold what is done; continue with `{} run --resume` in this folder\n",
        shell_command(program_words()));
  if (!matrix.refused.empty()) return bad_input;
  if (matrix.interrupted) return interrupted;
  if (!matrix.failed.empty() || (shard && !journal.is_open())) return harness_failure;
  return exit_code(rows, published_differs);
}

}  // namespace

Command add_run(App& app, const Context& context) {
  const auto options = std::make_shared<RunOptions>();
  add_options(app, options);
  return [=, &context] { return run(context, *options); };
}

}  // namespace cylon::cli
