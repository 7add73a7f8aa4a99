#include "harness/cli/selection.h"

#include "harness/cli/command_line.h"
#include "harness/cli/patterns.h"
#include "harness/cli/workers.h"
#include "harness/process/client.h"
#include "harness/scenario/glob.h"
#include "harness/scenario/input.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;
using process::EngineChoice;
using process::EngineRow;

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool any_match(const std::vector<std::string>& globs, const std::string& word) {
  return std::any_of(globs.begin(), globs.end(),
                     [&](const std::string& g) { return scenario::glob_match(g, word); });
}

std::vector<std::string> names_of(const std::vector<fs::path>& files) {
  std::vector<std::string> names;
  for (const fs::path& file : files) names.push_back(file.stem().string());
  return names;
}

// What is asked for, else what the suite lists, engines that the user adds, and variants that a pattern
// spells out.
std::vector<std::string> engine_ids(const Context& context, const std::vector<EngineRow>& rows,
                                    const Request& request, const std::vector<Pattern>& patterns,
                                    const scenario::Suite& suite) {
  std::vector<std::string> ids;
  const auto add = [&](const std::string& id) {
    if (!contains(ids, id)) ids.push_back(id);
  };
  if (request.engines.empty()) {
    for (const std::string& id : suite.engines) add(id);
    for (const EngineRow& row : rows)
      if (std::none_of(context.engines.begin(), context.engines.end(),
                       [&](const EngineRow& own) { return own.id == row.id; }))
        add(row.id);
    for (const Pattern& p : patterns)
      if (!p.exclude && !is_glob(p.engine)) add(p.engine);
    return ids;
  }
  for (const std::string& word : request.engines) {
    if (!is_glob(word)) {
      add(word);
      continue;
    }
    for (const std::string& id : suite.engines)
      if (scenario::glob_match(word, id)) add(id);
    for (const EngineRow& row : rows)
      if (scenario::glob_match(word, row.id)) add(row.id);
  }
  return ids;
}

// The choice itself, or a variant of it for each integrator that the globs match; one that states its
// integrator keeps it. What the engine has is added to `integrators`.
std::vector<EngineChoice> with_integrators(const EngineChoice& choice, const std::vector<EngineRow>& rows,
                                           const std::vector<std::string>& globs,
                                           std::vector<std::string>& integrators) try {
  if (globs.empty()) return {choice};
  std::vector<EngineChoice> choices;
  for (const core::Integrator& integrator : process::describe(choice).integrators) {
    if (!contains(integrators, integrator.name)) integrators.push_back(integrator.name);
    if (!any_match(globs, integrator.name) ||
        (!choice.integrator.empty() && choice.integrator != integrator.name))
      continue;
    const char* joint = choice.id.find('/') == std::string::npos ? "/" : ",";
    choices.push_back(choice.integrator.empty()
                          ? process::parse_engine(choice.id + joint + "integrator=" + integrator.name, rows)
                          : choice);
  }
  return choices;
} catch (const process::Failure&) {
  return {choice};  // its failure is a verdict of the run
}

bool same(const EngineChoice& a, const EngineChoice& b) {
  return a.row.id == b.row.id && a.path == b.path && a.integrator == b.integrator && a.options == b.options;
}

std::vector<EngineChoice> choose_engines(const Context& context, const std::vector<EngineRow>& rows,
                                         const Request& request, const std::vector<Pattern>& patterns,
                                         const scenario::Suite& suite) {
  std::vector<EngineChoice> engines;
  std::vector<std::string> integrators;
  for (const std::string& id : engine_ids(context, rows, request, patterns, suite)) {
    EngineChoice choice;
    try {
      choice = process::parse_engine(id, rows);
    } catch (const core::InputError& error) {
      throw core::InputError(fmt::format("--engine: {}", error.what()));
    }
    for (EngineChoice& variant : with_integrators(choice, rows, request.integrators, integrators))
      if (std::none_of(engines.begin(), engines.end(),
                       [&](const EngineChoice& other) { return same(other, variant); }))
        engines.push_back(std::move(variant));
  }
  for (const std::string& word : request.integrators)
    if (!is_glob(word) && !contains(integrators, word) && !integrators.empty())
      throw core::InputError(
          fmt::format("--integrator '{}': none of these engines has it{} (integrators: {})", word,
                      core::did_you_mean(word, integrators), fmt::join(integrators, ", ")));
  return engines;
}

struct Step {
  std::string text;
  double dt;
};

std::vector<Step> parse_steps(const std::vector<std::string>& words) {
  std::vector<Step> steps;
  for (const std::string& word : words) {
    const double dt = scenario::parse_step(word, "--dt");
    if (std::none_of(steps.begin(), steps.end(), [&](const Step& other) { return other.dt == dt; }))
      steps.push_back({word, dt});
  }
  return steps;
}

// A scenario that is not there; where an engine has that name, its option was left out.
core::InputError no_scenario(const Context& context, const std::vector<EngineRow>& rows,
                             const std::string& word) {
  if (std::none_of(rows.begin(), rows.end(), [&](const EngineRow& row) { return row.id == word; }))
    return unknown_scenario(context, word);
  return core::InputError(fmt::format(
      "'{0}' is an engine, not a scenario; an option takes one value each time, so write --engine {0}",
      word));
}

// A scenario as the user names it: a file by its path, one of the folder by its name.
struct Candidate {
  std::string given;
  fs::path file;
};

std::vector<Candidate> candidates(const Context& context, const std::vector<EngineRow>& rows,
                                  const Request& request, const std::vector<Pattern>& patterns,
                                  const scenario::Suite& suite) {
  std::vector<Candidate> found;
  for (const Pattern& p : patterns)
    if (!p.exclude && is_path(p.scenario) &&
        std::none_of(found.begin(), found.end(), [&](const Candidate& c) { return c.given == p.scenario; }))
      found.push_back({p.scenario, p.scenario});
  const std::vector<fs::path> files = scenario_files(context);
  const std::vector<std::string> names = names_of(files);
  for (const Pattern& p : patterns)
    if (!is_path(p.scenario) && !is_glob(p.scenario) && !contains(names, p.scenario))
      throw no_scenario(context, rows, p.scenario);
  for (const fs::path& file : files) {
    const std::string name = file.stem().string();
    // Patterns choose among all scenarios; a suite asked for by name, and no pattern at all, keep to the
    // suite.
    const bool in_suite = any_match(suite.scenarios, name);
    if (in_suite || (!patterns.empty() && request.suite.empty())) found.push_back({name, file});
  }
  std::erase_if(found, [&](const Candidate& c) { return !may_be_taken(patterns, c.given); });
  return found;
}

// expected.toml speaks of the folder's own scenarios: a file elsewhere that borrows a name is another
// scenario.
bool is_stranger(const Context& context, const scenario::Scenario& scenario) {
  const auto own = own_scenario(context, scenario.name);
  std::error_code ignored;
  if (!own || fs::equivalent(*own, scenario.file, ignored)) return false;
  return scenario::read(*own).hash != scenario.hash;
}

// `cylon [--sandbox] run SCENARIO --engine ID --dt S`, with the worker of an engine that is not built in, and plug-ins.
std::string command_for(const Context& context, const Request& request, const std::string& given,
                        const EngineChoice& engine, const std::string& step) {
  std::vector<std::string> words = program_words();
  words.insert(words.end(), {"run", given, "--engine", engine.id, "--dt", step});
  if (std::none_of(context.engines.begin(), context.engines.end(), [&](const EngineRow& own) {
        return own.id == engine.row.id && (engine.row.takes_plugins || own.command == engine.row.command);
      })) {
    words.emplace_back("--worker");
    words.push_back(fmt::format("{}={}", engine.row.id, fmt::join(engine.row.command, " ")));
  }
  if (engine.row.takes_plugins)
    for (const std::string& plugin : request.brought.plugins) words.insert(words.end(), {"--plugin", plugin});
  return shell_command(words);
}

// The options that change what a cell is asked, as they were given.
std::string unusual(const Request& request) {
  std::string text;
  if (request.metamorphic) text += " --metamorphic";
  if (request.theory) text += " --theory";
  if (request.tolerance_scale != 1) text += fmt::format(" --tolerance-scale {}", request.tolerance_scale);
  if (request.copies > 0) text += fmt::format(" --spread {}", request.copies);
  if (request.force) text += " --force";
  return text;
}

study::Exam exam_of(const Request& request) {
  if (request.metamorphic) return study::Exam::relations;
  return request.theory ? study::Exam::theory : study::Exam::claims;
}

}  // namespace

scenario::Suite find_suite(const Context& context, const std::vector<EngineRow>& rows,
                           const std::string& asked) {
  const std::string name = asked.empty() ? "conformance" : asked;
  const fs::path folder = context.scenarios / "suites";
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  if (contains(names, name)) return scenario::load_suite(folder / (name + ".toml"));
  if (!asked.empty())
    throw core::InputError(fmt::format("--suite '{}': no such suite in {}{} (suites: {})", name,
                                       folder.string(), core::did_you_mean(name, names),
                                       fmt::join(names, ", ")));
  scenario::Suite all;
  all.scenarios = {"*"};
  for (const EngineRow& row : rows)
    if (!row.optional()) all.engines.push_back(row.id);
  return all;
}

Selection select_unprepared(const Context& context, const Request& request) {
  const std::vector<EngineRow> rows = with_brought(context, request.brought);
  const std::vector<Pattern> patterns = parse_patterns(request.patterns);
  Selection selection;
  selection.suite = find_suite(context, rows, request.suite);
  const std::vector<Candidate> chosen = candidates(context, rows, request, patterns, selection.suite);
  const auto engines = choose_engines(context, rows, request, patterns, selection.suite);
  const auto steps = parse_steps(request.steps.empty() ? selection.suite.steps : request.steps);

  std::set<std::string> labels;
  for (const auto& [given, file] : chosen) {
    auto scenario = std::make_unique<scenario::Scenario>(scenario::read(file));
    const std::string known_as = is_stranger(context, *scenario) ? given : scenario->name;
    if (!labels.insert(scenario->name).second) scenario->name = given;  // two of one name in one report
    const std::vector<Step> nominal = {{scenario->step_text, scenario->step}};
    bool used = false;
    for (const EngineChoice& engine : engines) {
      if (!taken(patterns, given, engine.id)) continue;
      used = true;
      for (const auto& [text, dt] : steps.empty() ? nominal : steps)
        selection.cells.push_back({scenario.get(), engine, dt, text, known_as,
                                   command_for(context, request, given, engine, text) + unusual(request),
                                   exam_of(request), request.tolerance_scale, request.copies, request.force});
    }
    if (used) selection.scenarios.push_back(std::move(scenario));
  }
  return selection;
}

void prepare(Selection& selection) {
  std::set<const scenario::Scenario*> used;
  std::map<std::string, const EngineChoice*> engines;
  for (const study::Cell& cell : selection.cells) {
    used.insert(cell.scenario);
    engines.emplace(cell.engine.id, &cell.engine);
  }
  for (const auto& [id, engine] : engines) process::require_possible(*engine);
  std::erase_if(selection.scenarios, [&](const auto& scenario) { return !used.contains(scenario.get()); });
  for (const auto& scenario : selection.scenarios) scenario::prepare(*scenario);
}

Selection select(const Context& context, const Request& request) {
  Selection selection = select_unprepared(context, request);
  prepare(selection);
  return selection;
}

}  // namespace cylon::cli
