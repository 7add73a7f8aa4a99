#include "harness/cli/asked.h"

#include "harness/cli/command_line.h"
#include "harness/cli/workers.h"

#include "harness/core/engine.h"
#include "harness/core/input_error.h"
#include "harness/process/failure.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace cylon::cli {

void add_asked(App& app, Asked& asked, const std::string& engines) {
  app.add_option("file", asked.file, "A scenario file, or the name of a shipped scenario")
      ->type_name("FILE")
      ->required();
  app.add_option("--engine", asked.engine, engines)->type_name("ID")->capture_default_str();
  app.add_option("--integrator", asked.integrator,
                 "One of the engine's integrators (`cylon engines` lists them)")
      ->type_name("NAME");
  app.add_option("--tolerance", asked.tolerance,
                 "For integrators with error control: bound on the error at the printed times, relative to "
                 "the scales of the motion; --dt then sets the printed times only")
      ->type_name("T")
      ->check(positive(1));
  app.add_option("--model", asked.model,
                 "planned: only the stages that the scene needs; full: every stage (in-house engine)")
      ->type_name("NAME");
  add_brought_options(app, asked.brought);
}

process::EngineChoice choose(const Context& context, const Asked& asked) {
  process::EngineChoice engine = process::parse_engine(asked.engine, with_brought(context, asked.brought));
  const auto state = [&](const char* option, const std::string& value, std::string& place) {
    if (value.empty()) return;
    if (!place.empty() && place != value)
      throw core::InputError(fmt::format("{} {}: --engine {} states another", option, value, asked.engine));
    place = value;
  };
  state("--integrator", asked.integrator, engine.integrator);
  if (!asked.model.empty()) {
    require_option(engine, "--model", "model");
    state("--model", asked.model, engine.options["model"]);
  }
  return engine;
}

void require_option(const process::EngineChoice& engine, const char* of_command_line,
                    std::string_view of_engine) {
  try {
    const std::vector<core::Option> options = process::describe(engine).options;
    if (std::ranges::find(options, of_engine, &core::Option::name) != options.end()) return;
  } catch (const process::Failure&) {
    return;  // the run says why there is no such engine
  }
  throw core::InputError(
      fmt::format("{}: engine '{}' has no option '{}'; it is for the in-house engine alone", of_command_line,
                  engine.id, of_engine));
}

int report_failure(const std::string& engine, const process::RunOutcome& outcome) {
  std::cerr << plain_line(fmt::format("{}: {}: {}", engine, results::name(outcome.status), outcome.reason))
            << '\n';
  // An engine that is there and says that it cannot do this was asked for the wrong thing.
  return outcome.status == results::Status::unsupported && !outcome.engine.version.empty() ? bad_input
                                                                                           : harness_failure;
}

}  // namespace cylon::cli
