// The states that `cylon simulate --out` writes, read again.
#pragma once

#include "harness/core/trajectory.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace cylon::cli {

/// The columns, in their order: "time,body,px,…".
inline constexpr const char* states_header = "time,body,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz";

/// Larger files are refused [bytes].
inline constexpr std::size_t largest_states = std::size_t{256} << 20;

/// Reads `file`: times ascend, and each has a row for every body of the scene, in any order.  Numbers that
/// are not finite are taken as they are.  Throws core::InputError with file, line and column otherwise, and as
/// read_whole() does for what cannot be read, or never ends.
core::Trajectory read_states(const std::string& file, const core::Scene&);

/// The same of a text; `file` is its name in errors.
core::Trajectory parse_states(std::string_view text, const std::string& file, const core::Scene&);

}  // namespace cylon::cli
