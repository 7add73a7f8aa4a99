// cylon merge
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/commands/run_output.h"
#include "harness/cli/output.h"
#include "harness/cli/provenance_now.h"
#include "harness/cli/selection.h"
#include "harness/cli/union.h"
#include "reports/csv.h"
#include "reports/json.h"
#include "reports/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>

namespace cylon::cli {
namespace {

struct Options {
  std::vector<std::string> files;
  std::string json, junit, csv;

  std::vector<std::string> reports() const { return {json, junit, csv}; }
};

// All of them: a script may take them from here.
void list(const std::string& what, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  std::cerr << what << '\n';
  for (const std::string& line : lines) std::cerr << "  " << plain_line(line) << '\n';
}

// Takes them out of it, as there may be many.
std::vector<results::Verdict> take_verdicts(Union& all) {
  std::vector<results::Verdict> rows;
  for (const Unit& unit : all.part.units)
    if (const auto found = all.results.find(unit.key); found != all.results.end())
      std::ranges::move(found->second.verdicts, std::back_inserter(rows));
  return rows;
}

std::vector<std::string> without_verdicts(const Union& all) {
  std::vector<std::string> names;
  for (const Unit& unit : all.part.units)
    if (const auto found = all.results.find(unit.key);
        found != all.results.end() && found->second.verdicts.empty())
      names.push_back(unit.name);
  return names;
}

// The reports of a run, from its rows alone.
int report(const Context& context, const Options& options, Union& all, const scenario::Suite& suite) {
  const std::vector<results::Verdict> rows = take_verdicts(all);
  reports::Provenance provenance = provenance_now(context);
  if (!rows.empty()) provenance.tolerance_scale = rows.front().tolerance_scale;
  const std::vector<std::string> files = options.reports();
  const bool quiet = std::ranges::find(files, "-") != files.end();
  if (!quiet) print(context, {}, rows, all.part.units.size());
  // A part of the rows reproduces no table.
  const bool published_differs = all.missing.empty() && print_published(suite, rows, quiet);
  if (!options.json.empty()) write_whole(options.json, reports::to_json(rows, provenance));
  if (!options.junit.empty()) write_whole(options.junit, reports::to_junit(rows));
  if (!options.csv.empty()) write_whole(options.csv, reports::to_csv(rows));
  list("nothing is judged of:", without_verdicts(all));
  return rows.empty() ? static_cast<int>(nothing_selected) : exit_code(rows, published_differs);
}

int merge(const Context& context, const Options& options) {
  require_writable(options.reports());
  const std::vector<std::filesystem::path> files(options.files.begin(), options.files.end());
  Union all = unite(files);
  const std::string& command = all.part.command;
  if (command != "run" && options.reports() != Options().reports())
    throw core::InputError(
        fmt::format("these are parts of `cylon {0}`; merge them without a report, and write it with `cylon "
                    "{0} … --resume`",
                    command));
  const std::filesystem::path place = journal_file(command);
  const scenario::Suite suite =
      command == "run" ? find_suite(context, context.engines, all.part.suite) : scenario::Suite();
  write(all, place);
  if (all.strange > 0)
    std::cerr << fmt::format(
        "{} lines are cut off, no results, or were not written by you in this folder; they are not used\n",
        all.strange);
  const std::size_t count = all.part.units.size();
  std::cerr << fmt::format(
      "{} of {} are there; the union is {}{}\n", count - all.missing.size(), count, place.string(),
      command == "run"
          ? ""
          : fmt::format(", for `cylon {}{} … --resume`", all.sandboxed ? "--sandbox " : "", command));
  const int code = command == "run" ? report(context, options, all, suite) : static_cast<int>(ok);
  std::vector<std::string> missing;
  for (const Unit& unit : all.missing) missing.push_back(unit.name);
  list("missing:", missing);
  list("the same input gave other results:", all.contradictions);
  if (!all.missing.empty()) return incomplete;  // before all: whoever waits for the whole goes on waiting
  if (code == harness_failure) return code;
  return all.contradictions.empty() ? code : static_cast<int>(differs);
}

}  // namespace

Command add_merge(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option("files", options->files,
                 "Journals of shards, .cylon/journal-1-of-8.jsonl and so on, in any order; unions too")
      ->type_name("FILE")
      ->required();
  app.add_option("--json", options->json, "Write the rows as `cylon run --json` does; - is stdout")
      ->type_name("FILE");
  app.add_option("--junit", options->junit, "Write the rows as JUnit XML; - is stdout")->type_name("FILE");
  app.add_option("--csv", options->csv, "Write the rows as CSV; - is stdout")->type_name("FILE");
  app.footer(
      "The union is this folder's journal afterwards, and what that held before is kept: the same command\n"
      "with --resume does what is missing. Its rows are their authors' word; nothing that a file names is\n"
      "run. Motions are not in it: `cylon report` joins the files of each shard's --traces.\n"
      "Exit code 6: cells are missing, whatever else there is; all of them are listed. 1: a verdict or a\n"
      "published number differs, or two files answer one cell differently, times apart.");
  return [=, &context] { return merge(context, *options); };
}

}  // namespace cylon::cli
