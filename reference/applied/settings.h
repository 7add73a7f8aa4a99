// What a run of an optional engine sets: its path's rules, then what the run asks for, each with its reason.
#pragma once

#include "reference/applied/options.h"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::applied {

/// One run's settings.
struct Settings {
  std::string path, integrator;
  Values values;

  /// Why an option or the integrator is as it is, where a path or the run sets it.
  std::map<std::string, std::string> reasons;

  double at(std::string_view option) const { return values.find(option)->second; }
};

/// One setting of a path; "integrator" is one here.
struct Rule {
  const char *path, *option, *value, *where, *reason;
};

/// A rule that looks at the kind of a scene.
template <class Kind>
struct RuleFor : Rule {
  bool (*holds)(const Kind&);
};

/// The rules that hold for a kind.
template <class Kind, std::size_t n>
std::vector<Rule> holding(const RuleFor<Kind> (&rules)[n], const Kind& kind) {
  std::vector<Rule> all;
  for (const RuleFor<Kind>& rule : rules)
    if (rule.holds(kind)) all.push_back(rule);
  return all;
}

template <class Kind, std::size_t n>
std::vector<Rule> all(const RuleFor<Kind> (&rules)[n]) {
  return {std::begin(rules), std::end(rules)};
}

/// `base` with the rules that stand under its path, or under the setup's, and what the setup asks for.
/// Throws std::invalid_argument, naming the nearest valid one, for what the engine does not offer.
Settings chosen(Settings base, const Options&, const core::Engine&, const core::Setup&,
                const std::vector<Rule>& holding);

/// A setting as reports show it, beside that of `base`.
core::Setting shown(const Settings& run, const Settings& base, const Options&, const std::string& option,
                    const std::string& reason);

/// A path by the rules that stand under its name, after what holds on every path.
core::Path path(const char* name, std::string summary, const Settings& base, const Options&,
                const std::vector<Rule>& rules, std::vector<core::Setting> always,
                std::vector<std::string> unforceable);

}  // namespace cylon::applied
