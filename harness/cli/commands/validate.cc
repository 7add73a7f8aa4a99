// cylon validate
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"

#include "harness/core/input_error.h"
#include "harness/core/measure.h"

#include <fmt/format.h>

#include <cmath>
#include <iostream>

namespace cylon::cli {
namespace {

// A bound as wide as the motion is met by an engine that does nothing.
void warn_of_wide_bounds(const std::filesystem::path& file, const scenario::Scenario& scenario) {
  for (const core::Claim& claim : scenario.claims) {
    const double widest = core::widest(claim, scenario.scene, scenario.duration);
    if (std::isinf(widest)) continue;
    const double allowed = core::allowed(claim, scenario.scene, scenario.duration, core::epsilon_of_float);
    if (allowed > widest * (1 + 1e-6))
      std::cerr
          << plain_line(fmt::format(
                 "{}: warning: '{}' allows {:.3g} {}, more than a tenth of the range of the motion; that is "
                 "{:.3g}",
                 file.string(), claim.label, allowed, core::unit(claim), widest))
          << '\n';
  }
}

}  // namespace

Command add_validate(App& app, const Context& context) {
  struct Options {
    std::vector<std::string> files;
    bool schema = false;
  };
  const auto options = std::make_shared<Options>();
  const Option files =
      app.add_option("files", options->files,
                     "Scenario files, or names of shipped scenarios. Default: all shipped scenarios")
          ->type_name("FILE");
  app.add_flag("--schema", options->schema, "Print the JSON Schema of the scenario format instead")
      ->excludes(files);
  return [=, &context] {
    if (options->schema) {
      std::cout << scenario::schema_json();
      return ok;
    }
    bool good = true;
    const auto check = [&](const std::filesystem::path& file) {
      scenario::Scenario scenario = scenario::read(file);
      const bool solved = scenario::prepare_soon(scenario);
      std::cout << plain_line(
                       fmt::format("{}: ok: {} {}, {} {}{}", file.string(), scenario.scene.bodies.size(),
                                   scenario.scene.bodies.size() == 1 ? "body" : "bodies",
                                   scenario.claims.size(), scenario.claims.size() == 1 ? "claim" : "claims",
                                   solved ? ""
                                          : "; its certified truths take long to solve, so that their "
                                            "tolerances are checked when it runs"))
                << std::endl;
      warn_of_wide_bounds(file, scenario);
    };
    const auto attempt = [&](const auto& task) {
      try {
        task();
      } catch (const core::InputError& error) {
        show(error);
        good = false;
      }
    };
    for (const std::string& name : options->files) attempt([&] { check(find_scenario(context, name)); });
    if (options->files.empty()) {
      const auto shipped = scenario_files(context);
      if (shipped.empty()) {
        std::cerr << plain_line(
                         fmt::format("nothing selected: no scenario in {}", context.scenarios.string()))
                  << '\n';
        return nothing_selected;
      }
      for (const auto& file : shipped) attempt([&] { check(file); });
    }
    return good ? ok : bad_input;
  };
}

}  // namespace cylon::cli
