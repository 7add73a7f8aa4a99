// The kinds of joints by name; the engine knows what a joint keeps.
#pragma once

#include "engine/model.h"

namespace cylon::engine::joint_types {

using Place = Joint::Place;
using Turn = Joint::Turn;

inline constexpr Joint::Type ball{Place::together, Turn::freely}, hinge{Place::together, Turn::about_axis},
    distance{Place::at_length, Turn::freely}, fixed{Place::together, Turn::never},
    slider{Place::along_axis, Turn::never}, cylindrical{Place::along_axis, Turn::about_axis},
    planar{Place::in_plane, Turn::about_axis}, universal{Place::together, Turn::about_two_axes},
    screw{Place::along_axis, Turn::about_axis, true}, gimbal{Place::together, Turn::about_three_axes},
    rectangular{Place::in_plane, Turn::never}, offset_universal{Place::along_normal, Turn::about_two_axes};

/// Its place and its turn as two digits, for messages; a hundred more where they are coupled.
inline int label(const Joint::Type& type) {
  return (type.couples ? 100 : 0) + 10 * static_cast<int>(type.place) + static_cast<int>(type.turn);
}

}  // namespace cylon::engine::joint_types
