// A scene with the keys of a scenario file.
#pragma once

#include "harness/core/scene.h"

#include <nlohmann/json.hpp>

namespace cylon::view {

/// gravity, body, forces, joints, planes, materials, frame, with every digit: as TOML what the loader makes
/// the same scene of, up to the order of forces of different kinds.  The keys of process::to_json, less those
/// that the loader finds out itself; what a thing is called and what it is come first.
nlohmann::ordered_json scene_keys(const core::Scene&);

}  // namespace cylon::view
