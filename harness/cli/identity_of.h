// Which engine answers, as stored answers know it: by its content and by what it says of itself.
#pragma once

#include "harness/process/engines.h"

#include <span>
#include <string>
#include <vector>

namespace cylon::cli {

/// A hash of content_of() the engine's command, and of the name and version of its hello: what it loads from elsewhere (a
/// library of the system, a module that a wrapper names) shows in these alone.  Each engine is asked once in a process; one
/// that cannot be asked has no version.
std::string identity_of(const process::EngineRow&);

/// Asks the engines at one time, for identity_of().
void identify(std::span<const process::EngineRow>);

}  // namespace cylon::cli
