// The kinds of joints by name; the engine knows what a joint keeps.
#pragma once

#include "engine/model.h"

namespace cylon::engine::joint_types {

using Place = Joint::Place;
using Turn = Joint::Turn;

inline constexpr Joint::Type ball{Place::together, Turn::freely}, hinge{Place::together, Turn::about_axis},
    distance{Place::at_length, Turn::freely}, fixed{Place::together, Turn::never};

/// Its place and its turn as two digits, for messages.
inline int label(const Joint::Type& type) {
  return 10 * static_cast<int>(type.place) + static_cast<int>(type.turn);
}

}  // namespace cylon::engine::joint_types
