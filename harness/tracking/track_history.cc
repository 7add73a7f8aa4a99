// cylon track history
#include "harness/tracking/track_history_rows.h"
#include "harness/tracking/track_history_text.h"

#include "harness/cli/command_line.h"
#include "harness/scenario/glob.h"
#include "harness/tracking/track.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <set>

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

namespace {

struct Options {
  std::string file;
  HistorySelection wanted;
  bool json = false, changes = false;
};

// Which glob matches nothing, with the nearest name.
std::string nothing_found(const store::Store& store, const HistorySelection& wanted) {
  std::set<std::string> scenarios, engines, metrics;
  for (const store::Series& s : store.series("*", "*")) {
    scenarios.insert(s.cell.scenario);
    engines.insert(s.cell.engine);
    metrics.insert(s.metric.name);
  }
  std::string text = "nothing selected";
  const auto look = [&](const char* what, const std::string& glob, const std::set<std::string>& names) {
    const std::vector<std::string> list(names.begin(), names.end());
    if (std::none_of(list.begin(), list.end(), [&](const auto& n) { return scenario::glob_match(glob, n); }))
      text += fmt::format("; no {} '{}' in the history{}", what, glob, core::did_you_mean(glob, list));
  };
  look("scenario", wanted.scenario, scenarios);
  look("engine", wanted.engine, engines);
  look("metric", wanted.metric, metrics);
  return plain(text);
}

int history(const Context& context, const Options& options) {
  const store::Store store = store::Store::open(options.file, store::Mode::read);
  std::vector<HistoryRow> rows = history_rows(store, options.wanted);
  if (rows.empty()) {
    std::cerr << nothing_found(store, options.wanted) << '\n';
    if (options.json) std::cout << history_json(rows);
    return nothing_selected;
  }
  if (options.changes)
    std::erase_if(rows, [](const HistoryRow& row) { return row.changes.empty() && row.versions.empty(); });
  if (options.json)
    std::cout << history_json(rows);
  else
    std::cout << history_text(rows, {.width = context.width, .utf8 = context.utf8, .colour = context.colour});
  return ok;
}

}  // namespace

Command add_track_history(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option("--scenario", options->wanted.scenario, "Show only these scenarios")->type_name("GLOB");
  app.add_option("--engine", options->wanted.engine, "Show only these engines")->type_name("GLOB");
  app.add_option("--metric", options->wanted.metric,
                 "Show only these metrics: 'cpu_ratio:*', 'error:*', state_hash")
      ->type_name("GLOB");
  app.add_flag("--changes", options->changes, "Show only series that changed");
  app.add_flag("--json", options->json, "Print every point and every change as JSON");
  add_store_option(app, options->file);
  app.footer(
      "cpu_ratio:NAME is the time over that of the pinned binary NAME, run side by side (`cylon track pin`); "
      "only change points are searched in the ratios, because the speed of the machine changes too. `cylon "
      "track ack` and `cylon track ignore` store notes on a change.");
  return [options, &context] { return history(context, *options); };
}

}  // namespace cylon::tracking
