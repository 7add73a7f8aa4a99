#include "harness/cli/selection.h"

#include "harness/core/input_error.h"
#include "harness/process/client.h"
#include "scenarios/glob.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;

fs::path find_suite(const Context& context, const std::string& name) {
  const fs::path folder = context.scenarios / "suites";
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw core::InputError(fmt::format("--suite '{}': no such suite in {}{}", name, folder.string(), core::did_you_mean(name, names)));
  return folder / (name + ".toml");
}

// "bounce*:-*/ode": a list of globs, those with '-' excluded; each SCENARIO or SCENARIO/ENGINE.
struct Pattern {
  std::string scenario, engine = "*";
  bool exclude = false;
};

bool is_file(const std::string& word) {
  std::error_code ignored;
  return word.ends_with(".toml") && fs::exists(word, ignored);
}

std::vector<Pattern> parse(const std::vector<std::string>& words) {
  std::vector<Pattern> patterns;
  for (const std::string& word : words) {
    std::istringstream parts(word);
    for (std::string part; std::getline(parts, part, ':');) {
      Pattern pattern;
      if (part.starts_with('-')) pattern.exclude = true, part.erase(0, 1);
      if (is_file(part)) {
        pattern.scenario = part;
      } else {
        const std::size_t slash = part.find('/');
        pattern.scenario = part.substr(0, slash);
        if (slash != std::string::npos) pattern.engine = part.substr(slash + 1);
      }
      if (pattern.scenario.ends_with(".toml") && !is_file(pattern.scenario))
        throw core::InputError(fmt::format("{}: there is no such file", pattern.scenario));
      patterns.push_back(pattern);
    }
  }
  return patterns;
}

bool is_glob(const std::string& word) { return word.find_first_of("*?") != std::string::npos; }

// Whether the patterns take a scenario (by name or file) on an engine; with no including pattern, all are taken.
bool taken(const std::vector<Pattern>& patterns, const std::string& name, const std::string& file, const std::string& engine) {
  bool any = false, in = false;
  for (const Pattern& p : patterns) {
    const bool hit = (p.scenario == file || scenarios::glob_match(p.scenario, name)) && scenarios::glob_match(p.engine, engine);
    if (p.exclude && hit) return false;
    if (!p.exclude) any = true, in = in || hit;
  }
  return !any || in;
}

bool may_be_taken(const std::vector<Pattern>& patterns, const std::string& name, const std::string& file) {
  const bool none = std::all_of(patterns.begin(), patterns.end(), [](const Pattern& p) { return p.exclude; });
  return none || std::any_of(patterns.begin(), patterns.end(), [&](const Pattern& p) {
           return !p.exclude && (p.scenario == file || scenarios::glob_match(p.scenario, name));
         });
}

std::vector<std::string> engine_ids(const Context& context, const std::vector<process::EngineRow>& rows, const Request& request, const std::vector<Pattern>& patterns,
                                    const scenarios::Suite& suite) {
  std::vector<std::string> known = suite.engines;
  for (const process::EngineRow& row : rows)
    if (std::find(known.begin(), known.end(), row.id) == known.end()) known.push_back(row.id);
  if (request.engines.empty()) {
    // What the suite lists, engines that the user adds, and variants that a pattern spells out.
    std::vector<std::string> ids = suite.engines;
    for (const process::EngineRow& row : rows)
      if (std::none_of(context.engines.begin(), context.engines.end(), [&](const auto& own) { return own.id == row.id; }))
        ids.push_back(row.id);
    for (const Pattern& p : patterns)
      if (!p.exclude && !is_glob(p.engine) && std::find(ids.begin(), ids.end(), p.engine) == ids.end()) ids.push_back(p.engine);
    return ids;
  }
  std::vector<std::string> ids;
  const auto add = [&](const std::string& id) {
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
  };
  for (const std::string& word : request.engines) {
    if (is_glob(word)) {
      for (const std::string& id : known)
        if (scenarios::glob_match(word, id)) add(id);
    } else {
      add(word);
    }
  }
  return ids;
}

// The choice itself, or a variant of it for each scheme that the globs match.
std::vector<process::EngineChoice> with_integrators(const process::EngineChoice& choice, const std::vector<process::EngineRow>& rows,
                                                    const std::vector<std::string>& globs) {
  if (globs.empty()) return {choice};
  std::vector<process::EngineChoice> choices;
  for (const core::Scheme& scheme : process::describe(choice, {}).schemes)
    if (std::any_of(globs.begin(), globs.end(), [&](const std::string& glob) { return scenarios::glob_match(glob, scheme.name); }))
      choices.push_back(process::parse_engine(choice.id + (choice.id.find('/') == std::string::npos ? '/' : ',') + ("integrator=" + scheme.name), rows));
  return choices;
}

}  // namespace

Selection select(const Context& context, const std::vector<process::EngineRow>& rows, const Request& request) {
  Selection selection;
  selection.suite = scenarios::load_suite(find_suite(context, request.suite.empty() ? "conformance" : request.suite));
  const scenarios::Suite& suite = *selection.suite;
  const std::vector<Pattern> patterns = parse(request.patterns);

  std::vector<process::EngineChoice> engines;
  for (const std::string& id : engine_ids(context, rows, request, patterns, suite))
    for (process::EngineChoice& choice : with_integrators(process::parse_engine(id, rows), rows, request.integrators))
      engines.push_back(std::move(choice));

  std::vector<std::pair<std::string, fs::path>> files;  // name or path as given, file
  for (const Pattern& p : patterns)
    if (is_file(p.scenario)) files.emplace_back(p.scenario, p.scenario);
  for (const fs::path& file : scenario_files(context)) {
    const std::string name = file.stem().string();
    const bool in_suite = std::any_of(suite.scenarios.begin(), suite.scenarios.end(),
                                      [&](const std::string& glob) { return scenarios::glob_match(glob, name); });
    // Patterns choose among all scenarios; a suite asked for by name, and no pattern at all, keep to the suite.
    if ((patterns.empty() || !request.suite.empty()) && !in_suite) continue;
    files.emplace_back(name, file);
  }

  const std::vector<std::string>& steps = request.steps.empty() ? suite.steps : request.steps;
  for (const auto& [given, file] : files) {
    if (!patterns.empty() && !may_be_taken(patterns, file.stem().string(), given)) continue;
    auto scenario = std::make_unique<scenarios::Scenario>(scenarios::load(file));
    bool used = false;
    for (const process::EngineChoice& engine : engines) {
      if (!patterns.empty() && !taken(patterns, scenario->name, given, engine.id)) continue;
      used = true;
      if (steps.empty()) selection.cells.push_back({scenario.get(), engine, scenario->step, scenario->step_text});
      for (const std::string& text : steps) selection.cells.push_back({scenario.get(), engine, scenarios::parse_step(text), text});
    }
    if (used) selection.scenarios.push_back(std::move(scenario));
  }
  return selection;
}

}  // namespace cylon::cli
