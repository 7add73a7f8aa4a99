#include "harness/study/settings.h"

#include "harness/core/input_error.h"
#include "harness/scenario/glob.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>
#include <set>
#include <string_view>

namespace cylon::study {
namespace {

bool is_glob(const std::string& word) { return word.find_first_of("*?[") != std::string::npos; }

bool matches(const std::vector<std::string>& globs, const std::string& word) {
  return globs.empty() || std::any_of(globs.begin(), globs.end(),
                                      [&](const std::string& g) { return scenario::glob_match(g, word); });
}

bool springs(const core::Scene& scene) {
  return std::any_of(scene.forces.begin(), scene.forces.end(),
                     [](const core::Force& force) { return std::holds_alternative<core::Spring>(force); });
}

bool always(const core::Scene&) { return true; }

bool holds(const core::Scene& scene) { return !scene.joints.empty() || touches(scene); }

// What makes a variant of its own where it can matter.
struct Trial {
  const char* name;
  bool (*matters)(const core::Scene&);
};
// Options that are words, in every value that a row does not have by itself.  ODE's stepper is none of them: the row
// ode-quick is its other value.
constexpr Trial trial_options[] = {{"gyro", turns},
                                   {"rotation", turns},
                                   {"solver", touches},
                                   {"friction-direction", touches},
                                   {"springs", springs}};
// Options that are numbers: one value each, of those rows that take it.  The values are those of Bullet's path
// as-expert; 200 sweeps for both engines that sweep.
struct NumberTrial {
  const char *name, *value;
  std::initializer_list<std::string_view> rows;
  bool (*matters)(const core::Scene&);
};
const NumberTrial trial_numbers[] = {
    {"ccd", "0.9", {"bullet"}, touches},
    {"plane-queries", "3", {"bullet", "bullet-multibody"}, touches},
    {"breaking-threshold", "0.1", {"bullet", "bullet-multibody"}, touches},
    {"iterations", "200", {"bullet", "bullet-multibody", "ode-quick"}, holds}};
// Paths that an engine's first row does not take by itself.
constexpr Trial trial_paths[] = {{"stepping", touches}, {"as-expert", always}};

// The value of an option that a row has by itself: what its path forces, else the engine's own, else the first of ours, where the
// engine has no such thing.
std::string by_itself(const core::Engine& engine, const std::string& path, const core::Option& option) {
  const auto is_value = [&](const std::string& value) {
    return std::ranges::count(option.values, value) > 0;
  };
  for (const core::Path& of : engine.paths)
    if (of.name == (path.empty() ? engine.paths.front().name : path))
      for (const core::Setting& setting : of.settings)
        if (setting.name == option.name && is_value(setting.value)) return setting.value;
  if (is_value(option.engine_default) || option.values.empty()) return option.engine_default;
  return option.values.front();
}

std::vector<std::string> variants(const process::EngineChoice& choice, const core::Engine& engine,
                                  const core::Scene& scene, bool first_row) {
  const std::string& id = choice.id;
  std::vector<std::string> ids = {id};
  if (engine.precision == "float") return ids;
  for (const Trial& trial : trial_options)
    for (const core::Option& option : engine.options) {
      if (option.name != trial.name || !trial.matters(scene)) continue;
      const std::string own = by_itself(engine, choice.path, option);
      for (const std::string& value : option.values)
        if (value != own) ids.push_back(with_option(id, fmt::format("{}={}", option.name, value)));
    }
  for (const NumberTrial& trial : trial_numbers)
    if (std::ranges::find(trial.rows, id) != trial.rows.end() && trial.matters(scene))
      ids.push_back(with_option(id, fmt::format("{}={}", trial.name, trial.value)));
  for (const Trial& trial : trial_paths)
    for (std::size_t i = 1; i < engine.paths.size(); ++i)
      if (first_row && engine.paths[i].name == trial.name && trial.matters(scene))
        ids.push_back(with_option(id, fmt::format("path={}", trial.name)));
  return ids;
}

}  // namespace

std::string with_option(const std::string& id, const std::string& option) {
  return fmt::format("{}{}{}", id, id.find('/') == std::string::npos ? "/" : ",", option);
}

bool turns(const core::Scene& scene) {
  const auto unequal = [](const core::Body& b) {
    const core::Vector3 moments = core::principal_axes(b.inertia).moments;
    return moments.maxCoeff() - moments.minCoeff() > 1e-9 * moments.maxCoeff();
  };
  const bool driven = !scene.joints.empty() || touches(scene) || scene.frame.has_value();
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const core::Body& b) {
    return !b.locked && unequal(b) && (driven || !b.initial.angular_velocity.isZero(0));
  });
}

bool touches(const core::Scene& scene) {
  return core::any_touching_pair(scene, [](const core::Pair&) { return true; });
}

std::vector<Setting> settings(const scenario::Scenario& scenario, std::span<const process::EngineRow> rows,
                              const SettingsRequest& request) {
  std::vector<std::pair<std::string, bool>> ids;  // and whether it was asked for by name
  for (const std::string& word : request.engines) {
    if (!is_glob(word)) ids.emplace_back(word, true);
    for (const process::EngineRow& row : rows)
      if (is_glob(word) && scenario::glob_match(word, row.id)) ids.emplace_back(row.id, false);
  }
  if (request.engines.empty())
    for (const process::EngineRow& row : rows)
      if (!row.optional()) ids.emplace_back(row.id, false);

  std::vector<Setting> result;
  std::vector<std::string> integrators;
  std::set<std::vector<std::string>> seen;  // workers
  const auto add = [&](const std::string& id, const core::Engine& engine, bool asked) {
    const process::EngineChoice choice = process::parse_engine(id, rows);
    bool any_fixed = false;
    if (engine.integrators.empty()) result.push_back({choice, {}, true, asked});
    for (const core::Integrator& integrator : engine.integrators) {
      integrators.push_back(integrator.name);
      const bool first_fixed = !integrator.adaptive && !any_fixed;
      any_fixed |= !integrator.adaptive;
      if (choice.integrator.empty() ? matches(request.integrators, integrator.name)
                                    : integrator.name == choice.integrator)
        result.push_back({choice, integrator, first_fixed, asked});
    }
  };
  for (const auto& [id, asked] : ids) {
    const process::EngineChoice choice = process::parse_engine(id, rows);
    try {
      const core::Engine engine = process::describe(choice);
      process::require_possible(choice);
      const bool first_row = seen.insert(choice.row.command).second;
      const bool with_variants =
          request.engines.empty() || (request.searched && id.find('/') == std::string::npos);
      for (const std::string& variant :
           with_variants ? variants(choice, engine, scenario.scene, first_row) : std::vector<std::string>{id})
        add(variant, engine, asked);
    } catch (const process::Failure&) {
      result.push_back({choice, {}, true, asked});  // its failure is a row
    }
  }
  for (const std::string& word : request.integrators)
    if (!is_glob(word) && !integrators.empty() &&
        std::find(integrators.begin(), integrators.end(), word) == integrators.end()) {
      std::sort(integrators.begin(), integrators.end());
      integrators.erase(std::unique(integrators.begin(), integrators.end()), integrators.end());
      throw core::InputError(
          fmt::format("--integrator '{}': none of these engines has it{} (integrators: {})", word,
                      core::did_you_mean(word, integrators), fmt::join(integrators, ", ")));
    }
  return result;
}

}  // namespace cylon::study
