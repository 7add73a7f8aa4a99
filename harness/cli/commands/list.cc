// cylon list
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/scenario_view.h"

#include "harness/core/claim.h"
#include "harness/results/duration.h"
#include "harness/scenario/glob.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

namespace cylon::cli {
namespace {

struct Options {
  std::vector<std::string> globs, tags;
  bool json = false, names = false;
};

bool selected(const scenario::Scenario& scenario, const Options& options) {
  const auto matches = [&](const std::string& glob) { return scenario::glob_match(glob, scenario.name); };
  const auto tagged = [&](const std::string& tag) {
    return std::find(scenario.tags.begin(), scenario.tags.end(), tag) != scenario.tags.end();
  };
  return (options.globs.empty() || std::any_of(options.globs.begin(), options.globs.end(), matches)) &&
         std::all_of(options.tags.begin(), options.tags.end(), tagged);
}

// "bouncing_sphere to 9e-13 m": the first truth that is followed and its bound on its own error; "no truth".
// A certified truth is not solved for a list, so its bound is not known: "certified".
std::string truth_of(const scenario::Scenario& scenario) {
  for (const core::Claim& claim : scenario.claims)
    if (!claim.follows.empty())
      return claim.truth && !core::validates(claim)
                 ? fmt::format("{} to {:.0e} {}", claim.follows, claim.truth_error,
                               core::unit(claim.observable))
                 : claim.follows;
  return "no truth";
}

std::string nothing_found(const Options& options, const std::vector<std::string>& names,
                          const std::vector<std::string>& tags) {
  std::string text = "nothing selected";
  for (const std::string& glob : options.globs)
    if (std::none_of(names.begin(), names.end(),
                     [&](const std::string& name) { return scenario::glob_match(glob, name); }))
      text += fmt::format("; no scenario '{}'{}", glob, core::did_you_mean(glob, names));
  for (const std::string& tag : options.tags)
    if (std::find(tags.begin(), tags.end(), tag) == tags.end())
      text += fmt::format("; no tag '{}'{} (tags: {})", tag, core::did_you_mean(tag, tags),
                          fmt::join(tags, ", "));
  return plain(text);
}

int list(const Context& context, const Options& options) {
  std::vector<scenario::Scenario> found;
  std::vector<std::string> names, tags;
  for (const auto& file : scenario_files(context)) {
    scenario::Scenario scenario = scenario::read(file);
    names.push_back(scenario.name);
    for (const std::string& tag : scenario.tags)
      if (std::find(tags.begin(), tags.end(), tag) == tags.end()) tags.push_back(tag);
    if (selected(scenario, options)) found.push_back(std::move(scenario));
  }
  if (found.empty()) std::cerr << nothing_found(options, names, tags) << '\n';
  if (options.json) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (auto& scenario : found) {
      scenario::prepare(scenario);
      rows.push_back(scenario_facts(scenario));
    }
    std::cout << rows.dump(2, ' ', true) << '\n';
  } else if (options.names) {
    for (const auto& scenario : found) std::cout << scenario.name << '\n';
  } else {
    std::size_t width = 0;
    for (const auto& scenario : found) width = std::max(width, scenario.name.size());
    for (const auto& scenario : found) {
      std::cout << plain_line(fmt::format("{:<{}}  {:>5g} s at {:<8} {:>2} claims  {}  ({})  [{}]",
                                          scenario.name, width, scenario.duration,
                                          results::step_in_words(scenario.step_text), scenario.claims.size(),
                                          scenario.title, truth_of(scenario), fmt::join(scenario.tags, ", ")))
                << '\n';
    }
  }
  return found.empty() ? nothing_selected : ok;
}

}  // namespace

Command add_list(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option("globs", options->globs, "List only these scenarios")->type_name("GLOB");
  app.add_option("--tag", options->tags, "List only scenarios with this tag. Repeatable")
      ->allow_extra_args(false);
  const Option json = app.add_flag("--json", options->json, "Print JSON, with claims and tolerances");
  app.add_flag("--names", options->names, "Names alone")->excludes(json);
  return [=, &context] { return list(context, *options); };
}

}  // namespace cylon::cli
