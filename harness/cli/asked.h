// One scenario and one engine as a user asks for them: what `simulate` and `plan` have in common.
#pragma once

#include "harness/cli/brought.h"
#include "harness/cli/context.h"
#include "harness/process/client.h"

#include "harness/cli/parser.h"

#include <string>
#include <string_view>
#include <vector>

namespace cylon::cli {

struct Asked {
  std::string file, engine = "in-house", integrator, model;
  double tolerance = 0;  ///< 0: none given.
  Brought brought;
};

/// FILE, --engine, --integrator, --tolerance, --model, --worker and --plugin; `engines`: the help of --engine.
void add_asked(App&, Asked&,
               const std::string& engines = "Engine id, with a variant after '/': bullet/gyro=none");

/// The engine with integrator and model as options state them; throws core::InputError where the engine's
/// variant states others.
process::EngineChoice choose(const Context&, const Asked&);

/// Throws core::InputError, which names the option of the command line, where the engine has no such option.
void require_option(const process::EngineChoice&, const char* of_command_line, std::string_view of_engine);

/// Says on stderr why a run came to nothing; returns the exit code.
int report_failure(const std::string& engine, const process::RunOutcome&);

}  // namespace cylon::cli
