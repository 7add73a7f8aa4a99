// cylon plan
#include "harness/cli/asked.h"
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/options.h"

#include "harness/core/input_error.h"
#include "harness/process/client.h"
#include "harness/process/interruption.h"
#include "harness/scenario/input.h"
#include "reports/json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

namespace cylon::cli {
namespace {

using nlohmann::ordered_json;

struct Options {
  Asked asked;
  std::string dt;
  bool json = false;
};

// "  in   rotation      body 'top' turns": stages left out are dim where there is colour.
std::string table(const std::vector<core::Stage>& plan, bool colour) {
  std::size_t width = 0;
  for (const core::Stage& stage : plan) width = std::max(width, plain_line(stage.name).size());
  std::string text;
  for (const core::Stage& stage : plan) {
    const std::string line = fmt::format("{:3}  {:{}}  {}", stage.in ? "in" : "out", plain_line(stage.name),
                                         width, plain_line(stage.reason));
    text += colour && !stage.in ? fmt::format("  \x1b[2m{}\x1b[0m\n", line) : fmt::format("  {}\n", line);
  }
  return text;
}

ordered_json to_json(const std::string& scenario, const std::string& engine, const core::Terms& terms,
                     const core::Recording& start) {
  ordered_json diagnostics = ordered_json::array();
  for (const told::Diagnostic& d : start.diagnostics) diagnostics.push_back(reports::diagnostic_json(d));
  ordered_json stages = ordered_json::array();
  for (const core::Stage& stage : terms.plan)
    stages.push_back({{"name", stage.name}, {"in", stage.in}, {"reason", stage.reason}});
  return {{"scenario", scenario},           {"engine", engine}, {"path", terms.path},
          {"integrator", terms.integrator}, {"plan", stages},   {"diagnostics", diagnostics}};
}

int plan(const Context& context, const Options& options) {
  const scenario::Scenario scenario = scenario::read(find_scenario(context, options.asked.file));
  const process::EngineChoice engine = choose(context, options.asked);
  process::RunRequest request;
  request.scene = &scenario.scene;
  request.setup.dt = options.dt.empty() ? scenario.step : scenario::parse_step(options.dt, "--dt");
  request.setup.tolerance = options.asked.tolerance;
  const process::Interruptible until_told;
  const process::RunOutcome outcome = process::run(engine, request);
  if (outcome.status != results::Status::pass) return report_failure(options.asked.engine, outcome);
  const core::Terms& terms = outcome.terms;
  if (terms.plan.empty())
    throw core::InputError(fmt::format("engine '{}' reports no plan of its stages", engine.id));
  if (options.json) {
    std::cout << to_json(scenario.name, engine.id, terms, *outcome.recording).dump(2, ' ', true) << '\n';
    return ok;
  }
  const std::string path = terms.path.empty() ? "" : ", path " + terms.path;
  std::cout << plain_line(
                   fmt::format("{} on {}{}, integrator {}", scenario.name, engine.id, path, terms.integrator))
            << '\n'
            << table(terms.plan, context.colour);
  for (const told::Diagnostic& d : outcome.recording->diagnostics)
    std::cout << plain_line(fmt::format("  {}", plain_line(d.text))) << '\n';
  return ok;
}

}  // namespace

Command add_plan(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  add_asked(
      app, options->asked,
      "Engine id, with a variant after '/': in-house/joints=constraints. Only in-house and in-house-float "
      "have a plan, and engines of your own that report one");
  add_step_option(app, options->dt);
  app.add_flag("--json", options->json, "As JSON");
  return [=, &context] { return plan(context, *options); };
}

}  // namespace cylon::cli
