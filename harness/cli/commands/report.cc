// cylon report: builds a report from the output of other commands; nothing is simulated.
#include "harness/cli/commands/app.h"
#include "harness/cli/output.h"
#include "harness/cli/read_whole.h"
#include "harness/cli/scenario_view.h"
#include "harness/input/json.h"

#include "reports/console.h"
#include "reports/html.h"
#include "reports/json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iostream>
#include <set>
#include <sstream>
#include <utility>

namespace cylon::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> files;
  std::string html, title, baseline;
};

constexpr std::size_t longest_file = std::size_t{160} << 20;  // of a run with 10^5 verdicts 113 MB [bytes]

bool is_format(const Json& json, const char* format) {
  return json.contains("format") && json["format"] == format;
}

// The value of a line that may be JSON; discarded where it is none.
Json line_json(std::string_view line) {
  try {
    return input::parse_json<Json>(line);
  } catch (const input::BadJson&) {
    return Json::value_t::discarded;
  }
}

Json whole_json(const std::string& text, const std::string& path) {
  try {
    return input::parse_json<Json>(text);
  } catch (const input::BadJson& error) {
    throw core::InputError(fmt::format("{}: {}", path, error.what()));
  }
}

// Lines of scenarios and traces.
void take_traces(const std::string& text, const std::string& path, reports::HtmlReport& report) {
  if (input::memory_of(text) > input::largest_json)
    throw core::InputError(
        fmt::format("{}: values that take more than {} MB of memory", path, input::largest_json / 1'000'000));
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::string place = fmt::format("{}:{}", path, number);
    Json json = line_json(line);
    if (!json.is_object() || !is_format(json, "cylon-scenario/1")) {
      report.traces.push_back(reports::trace_from_json_line(line, place));
      continue;
    }
    if (!json.contains("name") || !json["name"].is_string())
      throw core::InputError(place + ": a scenario without its \"name\"");
    report.scenarios.push_back(std::move(json));
  }
}

void take(const std::string& path, reports::HtmlReport& report) {
  std::string text = read_whole(path, longest_file);
  const std::size_t first_end = text.find('\n');
  Json json = line_json(std::string_view(text).substr(0, first_end));
  if (json.is_object() && (is_format(json, "cylon-scenario/1") || is_format(json, "cylon-trace/1")))
    return take_traces(text, path, report);
  const bool one_line = first_end >= text.size() - 1;  // npos too
  if (json.is_discarded() || !one_line) {
    json = nullptr;  // never two of them
    json = whole_json(text, path);
  }
  text = std::string();
  std::vector<std::string> known = {"cylon run --traces", "cylon run --json"};
  if (json.is_object() && json.contains("verdicts")) {
    if (report.results)
      throw core::InputError(path +
                             ": a report takes one file of verdicts; use --baseline for an earlier one");
    report.results = reports::read_document(std::move(json), path);
    return;
  }
  for (const reports::Section& section : reports::sections) {
    if (json.is_object() && section.holds(json)) {
      report.documents[section.key].push_back(std::move(json));
      return;
    }
    known.emplace_back(section.written_by);
  }
  throw core::InputError(fmt::format("{}: not a document of Cylon; a report takes files written by {}", path,
                                     fmt::join(known, ", ")));
}

// What the verdicts are about, from the scenario files of this Cylon where they still are the same.
void add_scenarios(const Context& context, const std::vector<results::Verdict>& verdicts,
                   reports::HtmlReport& report) {
  std::set<std::string> there;
  for (const Json& view : report.scenarios) there.insert(view.at("name"));
  for (const results::Verdict& v : verdicts) {
    if (!there.insert(v.scenario).second) continue;
    const auto file = own_scenario(context, v.scenario);
    if (!file) continue;
    const scenario::Scenario scenario = scenario::load(*file);
    if (scenario.hash == v.scenario_hash) report.scenarios.push_back(scenario_view(scenario));
  }
}

int run(const Context& context, const Options& options) {
  if (!options.html.empty()) require_writable(options.html);
  if (options.html.empty() && !options.baseline.empty())
    throw core::InputError("--baseline: only a page compares with it; give --html FILE");
  reports::HtmlReport report;
  for (const std::string& file : options.files) take(file, report);
  if (!options.baseline.empty())
    report.baseline = reports::read_json(read_whole(options.baseline, longest_file), options.baseline);
  const std::vector<results::Verdict> none;
  const std::vector<results::Verdict>& verdicts = report.results ? report.results->verdicts : none;
  const reports::ConsoleOptions style{.width = context.width, .utf8 = context.utf8, .colour = context.colour};
  if (options.html.empty()) {
    if (verdicts.empty())
      throw core::InputError("--html FILE is needed: without it only verdicts can be shown");
    std::cout << reports::console_matrix(verdicts, style);
    return ok;
  }
  add_scenarios(context, verdicts, report);
  report.title = options.title;
  if (report.traces.empty() && !verdicts.empty())
    report.omitted_traces = "no file of `cylon run --traces` was given";
  write_whole(options.html, reports::to_html(std::move(report)));
  return ok;
}

}  // namespace

Command add_report(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option(
         "files", options->files,
         "Files written by `run --json`, `run --traces`, `matrix --json`, `trade --json`, `track compare "
         "--json`, "
         "`track history --json`, `hunt --json`, `predict --json` and `fit --json`, in any order; - is stdin")
      ->type_name("FILE")
      ->required();
  app.add_option("--html", options->html,
                 "Write the report as one HTML file; - is stdout. Without this option the matrix is printed")
      ->type_name("FILE");
  app.add_option("--baseline", options->baseline,
                 "An earlier file of `run --json`; the report shows the changes since then")
      ->type_name("FILE");
  app.add_option("--title", options->title,
                 "Title of the report. Default: the number of scenarios and engines")
      ->type_name("TEXT");
  return [=, &context] { return run(context, *options); };
}

}  // namespace cylon::cli
