// cylon merge
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/commands/run_output.h"
#include "harness/cli/output.h"
#include "harness/cli/provenance_now.h"
#include "harness/cli/union.h"
#include "reports/csv.h"
#include "reports/json.h"
#include "reports/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

namespace cylon::cli {
namespace {

struct Options {
  std::vector<std::string> files;
  std::string json, junit, csv;

  std::vector<std::string> reports() const { return {json, junit, csv}; }
};

constexpr std::size_t most_listed = 20;

void list(const std::string& what, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  std::cerr << what << '\n';
  for (std::size_t i = 0; i < std::min(lines.size(), most_listed); ++i)
    std::cerr << "  " << plain_line(lines[i]) << '\n';
  if (lines.size() > most_listed) std::cerr << fmt::format("  and {} more\n", lines.size() - most_listed);
}

std::vector<results::Verdict> verdicts_of(const Union& all) {
  std::vector<results::Verdict> rows;
  for (const Unit& unit : all.part.units)
    if (const auto found = all.lines.find(unit.key); found != all.lines.end())
      for (const auto& text : found->second.at("verdicts"))
        rows.push_back(reports::from_json_line(text.get<std::string>(), unit.name));
  return rows;
}

// The reports of a run, from its rows alone.
int report(const Context& context, const Options& options, const Union& all) {
  const std::vector<results::Verdict> rows = verdicts_of(all);
  reports::Provenance provenance = provenance_now(context);
  if (!rows.empty()) provenance.tolerance_scale = rows.front().tolerance_scale;
  const std::vector<std::string> files = options.reports();
  if (std::ranges::find(files, "-") == files.end()) print(context, {}, rows, all.part.units.size());
  if (!options.json.empty()) write_whole(options.json, reports::to_json(rows, provenance));
  if (!options.junit.empty()) write_whole(options.junit, reports::to_junit(rows));
  if (!options.csv.empty()) write_whole(options.csv, reports::to_csv(rows));
  return exit_code(rows, false);
}

int merge(const Context& context, const Options& options) {
  require_writable(options.reports());
  const std::vector<std::filesystem::path> files(options.files.begin(), options.files.end());
  const Union all = unite(files);
  const std::string& command = all.part.command;
  if (command != "run" && options.reports() != Options().reports())
    throw core::InputError(
        fmt::format("these are parts of `cylon {0}`; merge them without a report, and write it with `cylon "
                    "{0} … --resume`",
                    command));
  const std::filesystem::path place = journal_file(command);
  write(all, place);
  if (all.strange > 0)
    std::cerr << fmt::format("{} lines are cut off or no results; they are not used\n", all.strange);
  const std::size_t count = all.part.units.size();
  std::cerr << fmt::format("{} of {} are there; the union is {}{}\n", count - all.missing.size(), count,
                           place.string(),
                           command == "run" ? "" : fmt::format(", for `cylon {} … --resume`", command));
  const int code = command == "run" ? report(context, options, all) : static_cast<int>(ok);
  std::vector<std::string> missing;
  for (const Unit& unit : all.missing) missing.push_back(unit.name);
  list("missing:", missing);
  list("the same input gave other results:", all.contradictions);
  if (code == harness_failure) return code;
  if (!all.contradictions.empty() || code == differs) return differs;
  return all.missing.empty() ? code : incomplete;
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
      "The union is this folder's journal afterwards: the same command with --resume does what is missing "
      "and\n"
      "writes every report, as if one process had done all. Its rows are their authors' word; nothing that "
      "a\n"
      "file names is run. Exit code 6: cells are missing. A cell that two files answer differently, times\n"
      "apart, is exit code 1.");
  return [=, &context] { return merge(context, *options); };
}

}  // namespace cylon::cli
