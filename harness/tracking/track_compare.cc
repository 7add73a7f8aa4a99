// cylon track compare
#include "harness/tracking/track_compare.h"

#include "harness/cli/command_line.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/workers.h"
#include "harness/process/interruption.h"
#include "harness/study/compare.h"
#include "harness/study/paired_times.h"
#include "harness/tracking/baseline.h"
#include "harness/tracking/stored_baseline.h"
#include "reports/comparison_report.h"
#include "reports/markdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <optional>

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

namespace {

/// The command that compares this cell again.
std::string command_for(const CompareRequest& asked, const study::Cell& cell) {
  std::vector<std::string> words = program_words();
  words.insert(words.end(), {"track", asked.gate ? "gate" : "compare"});
  const auto option = [&](const char* name, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {name, value});
  };
  option("--baseline", asked.baseline);
  option("--candidate", asked.candidate);
  for (const std::string& worker : asked.baseline_workers) option("--baseline-worker", worker);
  for (const std::string& worker : asked.cells.brought.workers) option("--worker", worker);
  for (const std::string& plugin : asked.cells.brought.plugins) option("--plugin", plugin);
  words.insert(words.end(), {cell.known_as, "--engine", cell.engine.id, "--dt", cell.dt_text});
  return shell_command(words);
}

study::CompareOptions options_of(const CompareRequest& asked) {
  study::CompareOptions options;
  options.rule.tau = asked.tau;
  options.rule = study::up_to(options.rule, asked.max_pairs);
  options.time = !asked.no_time;
  options.gate = asked.gate;
  options.pinning = study::pin_to_one_processor();
  options.counter = asked.instructions == "auto" ? study::find_counter().counter
                                                 : study::counter_from(asked.instructions).value();
  options.limits.run_seconds = asked.timeout;
  return options;
}

std::vector<std::string> notes_of(const study::CompareOptions& options) {
  std::vector<std::string> notes;
  if (options.time) notes.push_back(options.pinning.says);
  const study::CounterFound& found = study::find_counter();
  notes.push_back(
      fmt::format("instructions: {}{}", study::name(options.counter),
                  options.counter == found.counter && !found.why.empty() ? " (" + found.why + ")" : ""));
  return notes;
}

/// The engines of the baseline that the user names one by one go before those of the folder.
void add_workers(study::Side& side, const Context& context, const std::vector<std::string>& workers) {
  Context none = context;
  none.engines.clear();
  for (const process::EngineRow& row : with_brought(none, {.workers = workers, .plugins = {}})) {
    std::erase_if(side.engines, [&](const process::EngineRow& other) { return other.id == row.id; });
    side.engines.push_back(row);
  }
}

/// Two builds side by side, or a run of the history whose build is not at hand.
struct Baseline {
  study::Side side;
  std::optional<store::RunInfo> run;
};

Baseline baseline_of(const Context& context, const CompareRequest& asked,
                     const std::vector<study::Cell>& cells) {
  const std::string& word = asked.baseline;
  const auto live = [&](study::Side side) {
    add_workers(side, context, asked.baseline_workers);
    add_plugins(side.engines, asked.cells.brought.plugins);
    return Baseline{std::move(side), std::nullopt};
  };
  if (word.empty()) return live({"the given workers", {}});
  if (!word.starts_with("run:")) {
    if (const auto folder = worker_folder(word)) return live(side_of_folder(word, *folder));
    if (const auto sha = revision_of(context, word))
      return live(side_of_revision(context, word, *sha, cells));
  }
  const auto run = stored_run(asked.store, word);
  if (!run)
    throw core::InputError(fmt::format(
        "--baseline {}: is no build folder, no binary, no git revision of {} and no run of {} (run:ID, or "
        "a label)",
        word, (context.scenarios / "..").lexically_normal().string(), asked.store));
  const auto binary = anchor_binary(asked.store, *run);
  if (!binary) return {{}, run};
  return live(
      side_of_folder(fmt::format("{} by its anchor {}", word, *binary), worker_folder(*binary).value()));
}

class Progress {
 public:
  explicit Progress(bool on) : on_(on) {}
  ~Progress() {
    if (on_) std::cerr << "\r\x1b[K" << std::flush;
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void operator()(const std::string& text) const {
    if (on_) std::cerr << "\r" << plain_line(text) << "\x1b[K" << std::flush;
  }

 private:
  bool on_;
};

/// `until_told` is made once there are two sides: a build of a revision ends by a signal.
results::ComparisonReport report_of(const Context& context, const CompareRequest& asked,
                                    const std::vector<study::Cell>& cells,
                                    std::optional<process::Interruptible>& until_told) {
  const Progress progress(context.progress);
  const auto show = [&](const std::string& text) { progress(text); };
  const study::CompareOptions options = options_of(asked);
  const study::Side candidate{asked.candidate.empty() ? "this build" : asked.candidate, context.engines};
  study::Side with_own = candidate;
  add_workers(with_own, context, asked.cells.brought.workers);
  add_plugins(with_own.engines, asked.cells.brought.plugins);
  const Baseline baseline = baseline_of(context, asked, cells);
  until_told.emplace();
  if (baseline.run) return compare_with_stored(asked.store, *baseline.run, cells, with_own, options, show);
  results::ComparisonReport report = study::compare(cells, baseline.side, with_own, options, show);
  const std::vector<std::string> notes = notes_of(options);
  report.notes.insert(report.notes.begin(), notes.begin(), notes.end());
  return report;
}

}  // namespace

bool nothing_compared(const results::ComparisonReport& report) {
  return std::ranges::all_of(report.cells, [](const results::Comparison& c) {
    return c.skip == results::Skip::missing || c.skip == results::Skip::unsupported;
  });
}

int exit_code(const results::ComparisonReport& report, bool strict) {
  const auto any = [&](results::Finding f) {
    return std::any_of(report.cells.begin(), report.cells.end(),
                       [&](const auto& c) { return c.finding == f; });
  };
  if (any(results::Finding::regressed)) return differs;
  if (nothing_compared(report)) return nothing_selected;
  const bool missing = std::ranges::any_of(
      report.cells, [](const results::Comparison& c) { return c.skip == results::Skip::missing; });
  return strict && (!report.reliable || missing || any(results::Finding::inconclusive)) ? inconclusive : ok;
}

int compare(const Context& own, const CompareRequest& asked) {
  const std::vector<std::string> files = {asked.json, asked.junit, asked.markdown};
  require_writable(files);
  if (asked.baseline.empty() && asked.baseline_workers.empty())
    throw core::InputError(
        "--baseline is missing: give a build folder, a binary, a git revision or a stored run; or "
        "--baseline-worker for your own engine");
  Context context = own;
  if (!asked.candidate.empty()) {
    const auto folder = worker_folder(asked.candidate);
    if (!folder)
      throw core::InputError(
          fmt::format("--candidate {}: is neither a build folder nor a binary", asked.candidate));
    context.engines = process::default_engines(*folder);
  }
  Selection selection = select(context, asked.cells);
  if (selection.cells.empty()) {
    std::cerr << "nothing selected; see `cylon list --names` and `cylon engines --names`\n";
    return nothing_selected;
  }
  for (study::Cell& cell : selection.cells) {
    study::sampling(*cell.scenario, cell.dt);  // refuse a bad step before any run
    cell.reproduce = command_for(asked, cell);
  }
  std::optional<process::Interruptible> until_told;
  const results::ComparisonReport report = report_of(context, asked, selection.cells, until_told);
  if (std::find(files.begin(), files.end(), "-") == files.end())
    std::cout << reports::console(report,
                                  {.width = context.width, .utf8 = context.utf8, .colour = context.colour});
  if (!asked.json.empty()) write_whole(asked.json, reports::to_json(report));
  if (!asked.junit.empty()) write_whole(asked.junit, reports::to_junit(report));
  if (!asked.markdown.empty()) write_whole(asked.markdown, reports::to_markdown(report));
  if (report.interrupted) {
    std::cerr << "interrupted: the reports hold what is compared; cells that were not reached are skipped\n";
    return interrupted;
  }
  if (nothing_compared(report))
    std::cerr << plain_line(fmt::format("nothing compared: {} of {} cells skipped; {}: {}",
                                        report.cells.size(), report.cells.size(), report.cells.front().cell(),
                                        report.cells.front().reason))
              << '\n';
  return exit_code(report, asked.strict);
}

void add_compare_options(App& app, CompareRequest& asked) {
  Request& cells = asked.cells;
  add_selection_options(app, cells);
  app.add_option(
         "--baseline", asked.baseline,
         "What to compare with: a build folder, a cylon binary, a git revision (built in a worktree under "
         ".cylon/baselines/, and kept), or a run of the history (run:ID or its label; accuracy only)")
      ->type_name("WHAT");
  app.add_option("--candidate", asked.candidate, "Build folder to test. Default: the build of this program")
      ->type_name("FOLDER");
  app.add_option("--baseline-worker", asked.baseline_workers,
                 "The older build of an engine that --worker adds, under the same name")
      ->type_name("NAME=COMMAND")
      ->allow_extra_args(false);
  app.add_option("--tau", asked.tau, "Ratios of times up to 1 + TAU count as the same")
      ->type_name("TAU")
      ->capture_default_str()
      ->check(positive(1));
  app.add_option("--max-pairs", asked.max_pairs,
                 "Largest number of pairs of runs for a cell, 8 to 40; then the cell is inconclusive")
      ->type_name("N")
      ->capture_default_str()
      ->check(in_range(8, 40));
  app.add_option("--instructions", asked.instructions, "auto, perf_event, callgrind or off")
      ->type_name("HOW")
      ->capture_default_str()
      ->check(one_of({"auto", "perf_event", "callgrind", "off"}));
  add_timeout_option(app, asked.timeout);
  app.add_flag("--no-time", asked.no_time, "Compare results only");
  app.add_flag("--strict", asked.strict,
               "Exit with 3 if a cell is inconclusive, or is in one build alone or runs in neither, or the "
               "environment is unreliable");
  app.add_option("--json", asked.json, "Write the comparison as JSON; - is stdout")->type_name("FILE");
  app.add_option("--junit", asked.junit, "Write it as JUnit XML; - is stdout")->type_name("FILE");
  app.add_option("--markdown", asked.markdown, "Write a summary for a merge request; - is stdout")
      ->type_name("FILE");
  add_store_option(app, asked.store);
}

Command add_track_compare(App& app, const Context& context) {
  const auto asked = std::make_shared<CompareRequest>();
  add_compare_options(app, *asked);
  app.footer(
      "Times: fresh processes in pairs, ABBA BAAB, exact signed-rank test; 'same' and 'inconclusive' are "
      "different "
      "answers. Results: errors may rise by 10 % or the rounding floor, orders fall by 0.1.\n"
      "Exit codes: 0 no regression, 1 a regression is confirmed, 2 bad input, 3 inconclusive under --strict, "
      "4 nothing "
      "selected or compared, 5 harness failure, 130 interrupted.");
  return [asked, &context] { return compare(context, *asked); };
}

}  // namespace cylon::tracking
