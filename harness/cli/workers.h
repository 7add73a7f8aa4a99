// Engines of the user's own: `--worker NAME=COMMAND`.
#pragma once

#include "harness/cli/context.h"
#include "harness/cli/parser.h"

#include <string>
#include <vector>

namespace cylon::cli {

/// `--worker NAME=COMMAND`: an engine of the user's own behind the worker protocol.
void add_worker_option(App&, std::vector<std::string>& workers);

/// The context's engines and those rows; throws core::InputError for a row without '=', an empty
/// command, or one whose program is not there.
std::vector<process::EngineRow> with_workers(const Context&, const std::vector<std::string>& workers);

}  // namespace cylon::cli
