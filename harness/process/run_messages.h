// What a run asks for, and what the worker tells of it beside its states: events, and the forces of contacts and
// joints (docs/protocol.md).
#pragma once

#include "harness/core/engine.h"
#include "harness/core/event.h"
#include "harness/core/scene.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace cylon::process {

/// Which steps to record, and which pairs to watch.
struct Run {
  std::int64_t steps = 0;        ///< >= 0
  std::int64_t every = 1;        ///< >= 1
  std::vector<std::int64_t> at;  ///< Ascending, in 1..steps.
  std::vector<core::Pair> watch;
  bool resume = false;    ///< From where the last run ended; steps count from there, and nothing is watched.
  bool contacts = false;  ///< Those of the last step, and the reactions of joints, are wanted.
};
nlohmann::json run_request(const Run&);
/// Throws MalformedMessage for steps out of range, too.
Run run_from_json(const nlohmann::json&);

/// The first step after `step` that is a multiple of `every`, stands in `at`, or is the last one.
std::int64_t next_sample(const Run&, std::int64_t step);

nlohmann::json event_json(const core::Event&);
core::Event event_from_json(const nlohmann::json& line);

/// What surfaces and joints did in the last step of a run.
struct ConstraintForces {
  std::vector<core::Contact> contacts;
  std::optional<std::vector<core::Reaction>> reactions;  ///< Absent: the engine does not tell.
};

/// Contacts and reactions of which a number is not finite are left out.
nlohmann::json constraint_forces_json(const ConstraintForces&);
/// The scene says what indices there are.
ConstraintForces constraint_forces_from_json(const nlohmann::json& line, const core::Scene&);

}  // namespace cylon::process
