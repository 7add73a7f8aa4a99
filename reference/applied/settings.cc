#include "reference/applied/settings.h"

#include <fmt/format.h>

#include <utility>

namespace cylon::applied {
namespace {

constexpr const char* asked_for = "asked for by the run";

void set(Settings& run, const Options& options, const std::string& option, const std::string& value) {
  if (option == "integrator")
    run.integrator = value;
  else
    options.set(run.values, option, value);
}

template <class Named>
std::vector<std::string> names(const std::vector<Named>& all) {
  std::vector<std::string> result;
  for (const Named& one : all) result.push_back(one.name);
  return result;
}

}  // namespace

Settings chosen(Settings run, const Options& options, const core::Engine& engine, const core::Setup& setup,
                const std::vector<Rule>& holding) {
  if (!setup.path.empty()) require(options.engine(), "path", setup.path, names(engine.paths));
  if (!setup.integrator.empty())
    require(options.engine(), "integrator", setup.integrator, names(engine.integrators));
  if (!setup.path.empty()) run.path = setup.path;
  for (const Rule& rule : holding)
    if (rule.path == run.path) {
      set(run, options, rule.option, rule.value);
      run.reasons[rule.option] = rule.reason;
    }
  if (!setup.integrator.empty()) {
    run.integrator = setup.integrator;
    run.reasons["integrator"] = asked_for;
  }
  for (const auto& [name, value] : setup.options) {
    options.set(run.values, name, value);
    run.reasons[name] = asked_for;
  }
  return run;
}

core::Setting shown(const Settings& run, const Settings& base, const Options& options,
                    const std::string& option, const std::string& reason) {
  if (option == "integrator") return {option, run.integrator, base.integrator, reason};
  const Option& one = options.row(option);
  return {one.setting, text(one, run.at(option)), text(one, one.engine_default), reason};
}

core::Path path(const char* name, std::string summary, const Settings& base, const Options& options,
                const std::vector<Rule>& rules, std::vector<core::Setting> always,
                std::vector<std::string> unforceable) {
  core::Path result{name, std::move(summary), std::move(always), std::move(unforceable)};
  for (const Rule& rule : rules) {
    if (std::string_view(rule.path) != name) continue;
    Settings there = base;
    set(there, options, rule.option, rule.value);
    result.settings.push_back(
        shown(there, base, options, rule.option, fmt::format("{}: {}", rule.where, rule.reason)));
  }
  return result;
}

}  // namespace cylon::applied
