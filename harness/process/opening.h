// How every conversation with a worker opens: hello, a scene, the state that was read back.
#pragma once

#include "harness/core/engine.h"
#include "harness/process/conversation.h"
#include "harness/process/engines.h"
#include "harness/process/messages.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cylon::process {

/// The command of a worker.  Throws Failure(unsupported) where an optional engine is not here.
std::vector<std::string> command_of(const EngineRow&);

/// Says hello under a deadline [s].  Throws Failure where the worker is unsupported or refuses; where an optional
/// engine's cannot start, with the command that brings what it needs.
Hello introduce(Conversation&, const EngineRow&, double seconds);

/// Loads a scene under a deadline [s] for that and all that follows.  What the choice states (path,
/// integrator, options) goes before the setup.  Throws Refused; core::InputError where the
/// worker calls the setup impossible, or where an integrator that does not control its error is given a
/// tolerance.
core::Terms open_scene(Conversation&, const EngineChoice&, const core::Scene&, const core::Setup&,
                       const core::Engine&, double seconds);

/// The state that follows a load.
core::State read_start(Conversation&, std::size_t bodies);

/// The text of an answer {"unsupported": …} or {"error": …}, cut to 1000 bytes, or nothing when it is another
/// message.
std::optional<std::string> text_of(const nlohmann::json& answer, const char* key);

/// Throws Failure(protocol) unless the answer is {"ok": what, …}.
void require_ok(const nlohmann::json& answer, const char* what);

}  // namespace cylon::process
