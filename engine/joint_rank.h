// How many of the conditions of joints are independent.
#pragma once

#include "engine/model.h"

#include <optional>

namespace cylon::engine {

/// Models with more rows of joints than this are not looked at: the work grows with the cube.
inline constexpr int most_ranked_rows = 400;

/// The rank of the rows of all joints, as functions of the velocities of what moves, where the bodies are at
/// the start; a pivot below sqrt(epsilon) of the largest is zero.  Joints that say the same twice count once:
/// the four hinges of a plane four-bar linkage have 20 rows of rank 17.  Nothing beyond most_ranked_rows.
std::optional<int> joint_rank(const Model&);

}  // namespace cylon::engine
