#include "harness/cli/commands/run_options.h"

#include <fmt/format.h>

namespace cylon::cli {

void add_options(App& app, const std::shared_ptr<RunOptions>& options) {
  Request& request = options->request;
  add_selection_options(app, request);
  const Option metamorphic = app.add_flag(
      "--metamorphic", request.metamorphic,
      "Check symmetries of mechanics instead of the claims: a moved, rotated, mirrored, boosted or "
      "rescaled scene must move alike, and time must be reversible. Needs no exact solution, so it "
      "works for any scene");
  app.add_flag(
         "--theory", request.theory,
         "Hold each engine to what its integrator promises, instead of the claims as they stand: errors "
         "within the bound of its declared order or tolerance, and falling with the step as declared. "
         "Only scenarios with a table [theory] are run (docs/claims.md)")
      ->excludes(metamorphic);
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
  app.add_flag(
      "--force", request.force,
      "Also run scenes that an engine refuses because they are too hard for it, and show the verdict. "
      "A scene that it cannot express stays refused");
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
  add_shard_options(app, options->shard, "cells");
  const Option rerun =
      app.add_flag("--rerun-failed", options->rerun_failed,
                   "Run only the cells that differed in the last run in this folder (.cylon/journal.jsonl)");
  app.add_flag("--resume", options->resume,
               "Continue the last run in this folder: finished cells are not run again")
      ->excludes(rerun);
  const Option verbose =
      app.add_flag("-v,--verbose", options->verbose,
                   "Print every claim of every cell, with the engine's settings; one cell alone is "
                   "printed so in any case, unless --brief is given");
  app.add_flag("--brief", options->brief, "Print no matrix: only what differs, and the counts")
      ->excludes(verbose);
}

std::string unusual_limits(const RunOptions& options) {
  const RunOptions usual;
  std::string text;
  if (options.timeout != usual.timeout) text += fmt::format(" --timeout {}", options.timeout);
  if (options.memory != usual.memory) text += fmt::format(" --memory {}", options.memory);
  return text;
}

}  // namespace cylon::cli
