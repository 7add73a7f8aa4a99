// cylon engines
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/commands/fingerprint.h"
#include "harness/cli/workers.h"

#include "harness/process/client.h"
#include "harness/scenario/glob.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <span>

namespace cylon::cli {
namespace {

using nlohmann::ordered_json;

struct Options {
  std::vector<std::string> globs;
  Brought brought;
  bool json = false, names = false, here = false, fingerprint = false;
};

ordered_json row(const process::EngineRow& row, const core::Engine& engine) {
  ordered_json paths = ordered_json::array(), integrators = ordered_json::array(),
               knobs = ordered_json::array();
  for (const core::Path& path : engine.paths) {
    ordered_json settings = ordered_json::array();
    for (const core::Setting& s : path.settings)
      settings.push_back(
          {{"name", s.name}, {"value", s.value}, {"engine_default", s.engine_default}, {"reason", s.reason}});
    paths.push_back({{"name", path.name},
                     {"summary", path.summary},
                     {"settings", settings},
                     {"unforceable", path.unforceable}});
  }
  for (const core::Integrator& s : engine.integrators)
    integrators.push_back(
        {{"name", s.name}, {"order", s.order}, {"conserves", s.conserves}, {"adaptive", s.adaptive}});
  for (const core::Option& o : engine.options)
    knobs.push_back({{"name", o.name},
                     {"values", o.values},
                     {"engine_default", o.engine_default},
                     {"meaning", o.meaning}});
  return {{"id", row.id},
          {"here", true},
          {"engine", engine.name},
          {"version", engine.version},
          {"precision", engine.precision},
          {"path", row.path},
          {"default_path_rule", engine.default_path_rule},
          {"paths", paths},
          {"schemes", integrators},
          {"options", knobs}};
}

// Whether a path is to be shown with a row: its own; where it has none, each; and, with the first row of a
// worker, those that no row of this worker means.
bool shown(const core::Path& path, const process::EngineRow& row, std::span<const process::EngineRow> table) {
  if (row.path.empty() || path.name == row.path) return true;
  const auto same = [&](const process::EngineRow& other) { return other.command == row.command; };
  const bool meant = std::ranges::any_of(
      table, [&](const process::EngineRow& other) { return same(other) && other.path == path.name; });
  const auto first = std::ranges::find_if(table, same);
  return !meant && !first->path.empty() && first->id == row.id;
}

std::string text(const process::EngineRow& row, const core::Engine& engine,
                 std::span<const process::EngineRow> table) {
  std::string out =
      fmt::format("{}: {} {}, {} precision\n", row.id, engine.name, engine.version, engine.precision);
  if (row.path.empty() && !engine.default_path_rule.empty())
    out += fmt::format("  path: {}\n", engine.default_path_rule);
  for (const core::Path& path : engine.paths) {
    if (!shown(path, row, table)) continue;
    out += fmt::format("  path {}: {}\n", path.name, path.summary);
    for (const core::Setting& s : path.settings)
      out +=
          fmt::format("    {} = {} (engine default: {}): {}\n", s.name, s.value, s.engine_default, s.reason);
    for (const std::string& sentence : path.unforceable)
      out += fmt::format("    known limit: {}\n", sentence);
  }
  for (const core::Integrator& s : engine.integrators)
    out += fmt::format("  integrator {}: order {}{}{}{}\n", s.name, s.order,
                       s.conserves.empty() ? "" : "; conserves ", s.conserves,
                       s.adaptive ? "; takes a tolerance" : "");
  for (const core::Option& o : engine.options) {
    const std::string values = o.values.empty() ? "NUMBER" : fmt::format("{}", fmt::join(o.values, "|"));
    out +=
        fmt::format("  option {}={} (engine default: {}): {}\n", o.name, values, o.engine_default, o.meaning);
  }
  return out + '\n';
}

// An optional engine that is not here: what brings it.
ordered_json absent(const process::EngineRow& row) {
  return {{"id", row.id}, {"here", false}, {"brought_by", row.brought_by}};
}

int engines(const Context& context, const Options& options) {
  int found = 0, broken = 0;
  ordered_json rows = ordered_json::array();
  const auto table = with_brought(context, options.brought);
  if (options.fingerprint) return fingerprint(table, options.globs, options.json);
  for (const process::EngineRow& engine : table) {
    const auto matches = [&](const std::string& glob) { return scenario::glob_match(glob, engine.id); };
    if (!options.globs.empty() && std::none_of(options.globs.begin(), options.globs.end(), matches)) continue;
    ++found;
    if (options.names) {
      std::cout << engine.id << '\n';
      continue;
    }
    if (process::missing(engine)) {
      if (options.json)
        rows.push_back(absent(engine));
      else
        std::cout << plain(fmt::format("{}: not here: `{}` brings it\n{}", engine.id, engine.brought_by,
                                       options.here ? "" : "\n"));
      continue;
    }
    try {
      const core::Engine description = process::describe(process::parse_engine(engine.id, table), {});
      if (options.json)
        rows.push_back(row(engine, description));
      else if (options.here)
        std::cout << plain_line(fmt::format("{}: here: {} {}, {} precision", engine.id, description.name,
                                            description.version, description.precision))
                  << '\n';
      else
        std::cout << plain(text(engine, description, table));
    } catch (const process::Failure& failure) {
      ++broken;
      std::cerr << plain_line(fmt::format("{}: {}", engine.id, failure.what())) << '\n';
    }
  }
  if (!found) {
    std::vector<std::string> ids;
    for (const process::EngineRow& engine : table) ids.push_back(engine.id);
    std::cerr << plain_line(fmt::format("nothing selected: no engine matches '{}'{} (engines: {})",
                                        fmt::join(options.globs, "', '"),
                                        core::did_you_mean(options.globs.front(), ids), fmt::join(ids, ", ")))
              << '\n';
  }
  if (options.json) std::cout << rows.dump(2, ' ', true) << '\n';
  return broken ? harness_failure : found ? ok : nothing_selected;
}

}  // namespace

Command add_engines(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option("globs", options->globs, "List only these engines")->type_name("GLOB");
  const Option here =
      app.add_flag("--here", options->here,
                   "A line each: whether the engine is here, and the command that brings it where it is not");
  const Option json = app.add_flag("--json", options->json, "As JSON")->excludes(here);
  const Option fingerprint =
      app.add_flag("--fingerprint", options->fingerprint,
                   "Measure what each engine does, with a dozen small scenes: integrator, order, gyroscopic "
                   "torque, restitution, friction, hidden limits. Accepts variants (bullet/gyro=none)")
          ->excludes(here);
  app.add_flag("--names", options->names, "Print the ids only")
      ->excludes(here)
      ->excludes(json)
      ->excludes(fingerprint);
  add_brought_options(app, options->brought);
  return [=, &context] { return engines(context, *options); };
}

}  // namespace cylon::cli
