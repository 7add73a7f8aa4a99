// The JSON lines of protocol version 1, one function per message and direction; docs/protocol.md is the text.
#pragma once

#include "harness/core/engine.h"
#include "harness/core/event.h"

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

/// Which steps to record, and which pairs to watch.
struct Run {
  std::int64_t steps = 0;        ///< >= 0
  std::int64_t every = 1;        ///< >= 1
  std::vector<std::int64_t> at;  ///< Ascending, in 1..steps.
  std::vector<core::Pair> watch;
  bool resume = false;    ///< From where the last run ended; steps count from there, and nothing is watched.
  bool contacts = false;  ///< Those of the last step are wanted.
};
nlohmann::json run_request(const Run&);
/// Throws MalformedMessage for steps out of range, too.
Run run_from_json(const nlohmann::json&);

/// The first step after `step` that is a multiple of `every`, stands in `at`, or is the last one.
std::int64_t next_sample(const Run&, std::int64_t step);

nlohmann::json event_json(const core::Event&);
core::Event event_from_json(const nlohmann::json& line);

/// Contacts of which a number is not finite are left out.
nlohmann::json contacts_json(const std::vector<core::Contact>&);
/// `bodies`, `planes`: how many the scene has.
std::vector<core::Contact> contacts_from_json(const nlohmann::json& line, std::size_t bodies,
                                              std::size_t planes);

/// The end of a run.
struct Done {
  std::int64_t steps = 0, frames = 0;
  double step_ns = 0;  ///< Thread CPU time of all steps together, recording and watching left out [ns].
  double load_ns = 0;  ///< Thread CPU time of the load before it; 0: the worker does not tell [ns].
  std::vector<std::string> remarks;
};
nlohmann::json done_json(const Done&);
Done done_from_json(const nlohmann::json&);

/// One line with its end; text that is not UTF-8 is repaired, numbers that are not finite become null.
std::string line(const nlohmann::json&);

}  // namespace cylon::process
