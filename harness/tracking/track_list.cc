// cylon track list
#include "harness/tracking/track.h"

#include "harness/cli/command_line.h"
#include "reports/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

namespace {

using store::Judgement;
using store::Result;
using store::RunInfo;
using store::Sample;

struct Options {
  std::string file, run;
  bool json = false;
};

using Table = std::vector<std::vector<std::string>>;

// Columns as wide as their widest word, two spaces between them.
void print(const Table& table) {
  std::vector<int> widths;
  for (const auto& row : table) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], reports::display_width(row[i]));
  }
  for (const auto& row : table) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
      line += i + 1 == row.size() ? row[i] : reports::fitted(row[i], widths[i], "") + "  ";
    line.erase(line.find_last_not_of(' ') + 1);
    std::cout << line << '\n';
  }
}

nlohmann::ordered_json to_json(const RunInfo& r) {
  return {{"id", r.id},
          {"uid", r.uid},
          {"label", r.label},
          {"revision", r.revision},
          {"order", r.revision_order.value_or(0)},
          {"date", r.date},
          {"machine", r.machine},
          {"build", r.build},
          {"complete", r.complete},
          {"note", r.note}};
}

int list_runs(const store::Store& store, const Options& options) {
  const std::vector<RunInfo> runs = store.runs();
  if (options.json) {
    auto rows = nlohmann::ordered_json::array();
    for (const RunInfo& run : runs) rows.push_back(to_json(run));
    std::cout << rows.dump(1) << '\n';
    return ok;
  }
  if (runs.empty()) std::cout << "no run yet\n";
  Table table = {{"run", "order", "revision", "label", "date", "build", "", "machine"}};
  for (const RunInfo& r : runs)
    table.push_back({fmt::format("{}", r.id), fmt::format("{}", r.revision_order.value_or(0)), r.revision,
                     r.label, r.date, r.build.substr(0, 8), r.complete ? "" : "incomplete", r.machine});
  if (!runs.empty()) print(table);
  return ok;
}

std::string value_of(const std::vector<const Sample*>& samples) {
  const Sample& first = *samples.front();
  if (!first.text.empty()) return first.text;
  double least = first.value, most = first.value;
  for (const Sample* s : samples) least = std::fmin(least, s->value), most = std::fmax(most, s->value);
  if (std::isnan(least)) return "not finite";
  const std::string unit = first.metric.unit.empty() ? "" : " " + first.metric.unit;
  return samples.size() == 1 ? fmt::format("{:.6g}{}", least, unit)
                             : fmt::format("{:.4g} … {:.4g}{} ({} times)", least, most, unit, samples.size());
}

int list_values(const store::Store& store, const RunInfo& run) {
  std::cout << fmt::format("run {} of {}, {}{}{}\n", run.id, run.revision, run.date,
                           run.label.empty() ? "" : ", " + run.label, run.complete ? "" : ", incomplete");
  for (const std::string& line : {run.machine, run.os, run.compiler + " " + run.flags, run.command_line})
    std::cout << "  " << line << '\n';
  for (const Result& result : store.results(run.id)) {
    std::cout << fmt::format("\n{}  ({})\n", result.cell.name(),
                             fmt::join(std::vector<std::string>{result.cell.path, result.cell.integrator,
                                                                result.cell.precision, result.engine_version},
                                       ", "));
    Table table;
    for (const Judgement& j : result.judgements)
      table.push_back({"  " + j.claim, j.status,
                       std::isnan(j.measured)
                           ? j.detail
                           : fmt::format("{:.3g} of {:.3g} {}", j.measured, j.allowed, j.unit)});
    std::map<std::string, std::vector<const Sample*>> by_metric;
    for (const Sample& s : result.samples)
      if (s.metric.kind != store::Kind::error || !s.metric.name.starts_with("error:"))
        by_metric[s.metric.name].push_back(&s);
    for (const auto& [name, samples] : by_metric)
      table.push_back(
          {"  " + name, std::string(store::name(samples.front()->metric.kind)), value_of(samples)});
    print(table);
  }
  return ok;
}

int list(const Options& options) {
  const store::Store store = store::Store::open(options.file, store::Mode::read);
  return options.run.empty() ? list_runs(store, options) : list_values(store, find_run(store, options.run));
}

}  // namespace

Command add_track_list(App& app, const Context&) {
  const auto options = std::make_shared<Options>();
  const Option run =
      app.add_option(
             "run", options->run,
             "Run whose values are printed: its number, the first digits of its uid, its label or its "
             "revision. None: all runs")
          ->type_name("RUN");
  app.add_flag("--json", options->json, "Print the list of runs as JSON")->excludes(run);
  add_store_option(app, options->file);
  return [options] { return list(*options); };
}

}  // namespace cylon::tracking
