// Engines and plug-ins of the user's own: `--worker NAME=COMMAND` and `--plugin NAME=FILE`.
#pragma once

#include "harness/cli/brought.h"
#include "harness/cli/context.h"
#include "harness/cli/parser.h"

#include <string>
#include <vector>

namespace cylon::cli {

/// `--worker NAME=COMMAND`: an engine of the user's own behind the worker protocol.  `--plugin NAME=FILE`: a library with
/// forces of the user's own, which scenes may name from then on.
void add_brought_options(App&, Brought&);

/// The context's engines and those of the user, with the plug-ins.  Throws core::InputError for a worker without '=', an
/// empty command, or one whose program is not there; and as add_plugins().
std::vector<process::EngineRow> with_brought(const Context&, const Brought&);

/// Lets the plug-ins take part in each engine that takes any.  Throws core::InputError for one without '=', a name that is
/// taken, and a file that is not there.
void add_plugins(std::vector<process::EngineRow>&, const std::vector<std::string>& plugins);

}  // namespace cylon::cli
