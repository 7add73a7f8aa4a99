// A scene as the tables of a scenario file.
#pragma once

#include "harness/core/scene.h"

#include <string>
#include <string_view>

namespace cylon::view {

/// gravity, [[body]], forces, joints, planes, materials, frame, with every digit: what the loader makes the
/// same scene of.  Key by key as `cylon validate` knows them.
std::string scene_toml(const core::Scene&);

/// A TOML string, quotes included.
std::string toml_text(std::string_view);

}  // namespace cylon::view
