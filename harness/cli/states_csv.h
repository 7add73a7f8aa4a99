// The states that `cylon simulate --out` writes, read again.
#pragma once

#include "harness/core/trajectory.h"

#include <string>

namespace cylon::cli {

/// The columns, in their order: "time,body,px,…".
inline constexpr const char* states_header = "time,body,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz";

/// Reads `file`: times ascend, and each has a row for every body of the scene, in any order.  Numbers that
/// are not finite are taken as they are.  Throws core::InputError with file, line and column otherwise.
core::Trajectory read_states(const std::string& file, const core::Scene&);

}  // namespace cylon::cli
