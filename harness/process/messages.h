// The JSON lines of protocol version 1, one function per message and direction; docs/protocol.md is the text.
#pragma once

#include "harness/core/engine.h"
#include "harness/core/event.h"
#include "harness/told/diagnostic.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::process {

inline constexpr int protocol_version = 1;

/// What a worker answers to hello.
struct Hello {
  core::Engine engine;
  bool events = false;  ///< It watches pairs itself; else the harness does, from every step.
  bool live = false;    ///< It goes on from where a run ended, and tells contacts.
};
nlohmann::json hello_json(const Hello&);
Hello hello_from_json(const nlohmann::json&);

nlohmann::json load_request(const core::Scene&, const core::Setup&);
core::Setup setup_from_json(const nlohmann::json& load_request);
nlohmann::json terms_json(const core::Terms&);
core::Terms terms_from_json(const nlohmann::json&);

/// The end of a run.
struct Done {
  std::int64_t steps = 0, frames = 0;
  double step_ns = 0;  ///< Thread CPU time of all steps together, recording and watching left out [ns].
  double load_ns = 0;  ///< Thread CPU time of the load before it; 0: the worker does not tell [ns].
  std::vector<std::string> remarks = {};
  std::vector<told::Diagnostic> diagnostics = {};
  std::vector<core::Work> works = {};
};
nlohmann::json done_json(const Done&);
Done done_from_json(const nlohmann::json&);

/// One line with its end; text that is not UTF-8 is repaired, numbers that are not finite become null.
std::string line(const nlohmann::json&);

}  // namespace cylon::process
