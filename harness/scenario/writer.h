// A scene as the text of a scenario file.
#pragma once

#include "harness/core/scene.h"

#include <string>
#include <string_view>

namespace cylon::scenario {

/// gravity, impacts, [[body]], forces, joints, planes, materials and [frame], with every digit: the reader
/// makes the same scene of it, up to the order of forces of different kinds.  A file can state one gravity,
/// so several are summed.  Keys of the top come first; further [[tables]] may follow.
std::string to_toml(const core::Scene&);

/// A text in quotes and a number as TOML reads them back; a whole number has a point, "3.0".
std::string toml_text(std::string_view);
std::string toml_number(double);

}  // namespace cylon::scenario
