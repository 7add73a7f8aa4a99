// A Scene as the JSON that workers get: the keys of the scenario format, generators and meshes expanded,
// every default written out.  docs/protocol.md lists the keys.
#pragma once

#include "harness/core/scene.h"

#include <nlohmann/json.hpp>

namespace cylon::process {

/// Bodies are referred to by name; a spring's end in the world is `pin`, a joint's is an absent `to`.
/// Forces are grouped by kind (gravity, spring, drag, thrust, drive, attraction, water), each in the scene's
/// order; gravity is the sum of all UniformGravity, zero where there is none.
/// Throws std::invalid_argument where two bodies share a name, or an attraction points at the world.
nlohmann::json to_json(const core::Scene&);

/// Inverse of to_json up to the order of forces of different kinds: every double comes back with the same
/// bits.  Zero gravity gives no force.  Throws MalformedMessage with the key.
core::Scene scene_from_json(const nlohmann::json&);

}  // namespace cylon::process
