// Coordinates of joints and their rates, as rows of the table of observables.
#pragma once

#include "harness/core/observable_rows.h"

namespace cylon::core {

/// Why no joint that is asked for has such a coordinate, or nothing.
std::optional<std::string> joint_value_undefined(const Observable&, const Scene&);

/// One scalar for each joint that is asked for and has it.
void joint_values(const Observable&, const Scene&, const State&, Values&);

double joint_value_error(const Observable&, const Scene&, const State&, const StateError&);

}  // namespace cylon::core
