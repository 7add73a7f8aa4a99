// The kinds of joints, one row each: what a joint keeps of the motion of its two bodies against each other.
// A kind of known keeps is one row; whoever writes equations switches over the keeps, and a new keep does not
// compile there.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace cylon::core {

enum class JointType {
  ball,
  hinge,
  distance,
  fixed,
  slider,
  cylindrical,
  planar,
  universal,
  screw,
  gimbal,
  rectangular,
  offset_universal
};

/// What a joint keeps of the two points that it joins; d is from the point on `to` to that on `body`.
enum class JointPlace {
  together,   ///< They coincide.
  at_length,  ///< Their distance is `length`.  The points are centres of mass, or one is a point of the world.
  along_axis,   ///< d is parallel to `axis`.
  in_plane,     ///< d is square to `axis`.
  along_normal  ///< d is `length` times axis x axis_2.
};

/// How the two bodies of a joint may turn against each other.
enum class JointTurn {
  freely,
  about_axis,  ///< Only about `axis`, which is fixed in both.
  never,
  about_two_axes,   ///< About `axis`, fixed in `to`, and `axis_2`, fixed in `body`; the two stay square.
  about_three_axes  ///< About the same two and the line square to both: every turn, with angles that count it.
};

struct JointKind {
  JointType type;
  std::string_view name;  ///< In files and between processes.
  JointPlace place;
  JointTurn turn;
  bool screws = false;  ///< The one displacement is `pitch` times the one angle.

  constexpr bool has_axis() const {
    return turns_about_axis() || turns_between_axes() || place == JointPlace::along_axis ||
           place == JointPlace::in_plane;
  }
  constexpr bool has_second_axis() const { return turns_between_axes() || place == JointPlace::in_plane; }
  /// About an axis that `to` carries and one that `body` carries.
  constexpr bool turns_between_axes() const {
    return turn == JointTurn::about_two_axes || turn == JointTurn::about_three_axes;
  }
  /// No turn is kept from being.
  constexpr bool turns_freely() const {
    return turn == JointTurn::freely || turn == JointTurn::about_three_axes;
  }
  /// The second axis is square to the first.
  constexpr bool has_square_axes() const { return has_second_axis() && turn != JointTurn::about_three_axes; }
  /// Joins the centres of mass, or one and a point of the world; else both bodies at one point.
  constexpr bool joins_centres() const { return place == JointPlace::at_length; }
  constexpr bool has_length() const {
    return place == JointPlace::at_length || place == JointPlace::along_normal;
  }
  /// The one rotation that is left is about the axis.
  constexpr bool turns_about_axis() const { return turn == JointTurn::about_axis; }

  /// How many displacements and angles are free and have a name (joint_coordinates.h).
  constexpr int displacements() const {
    return place == JointPlace::in_plane ? 2 : place == JointPlace::along_axis && !screws ? 1 : 0;
  }
  constexpr int angles() const {
    return turn == JointTurn::about_three_axes ? 3
           : turn == JointTurn::about_two_axes ? 2
           : turns_about_axis()                ? 1
                                               : 0;
  }
};

inline constexpr std::array joint_kinds = {
    JointKind{JointType::ball, "ball", JointPlace::together, JointTurn::freely},
    JointKind{JointType::hinge, "hinge", JointPlace::together, JointTurn::about_axis},
    JointKind{JointType::distance, "distance", JointPlace::at_length, JointTurn::freely},
    JointKind{JointType::fixed, "fixed", JointPlace::together, JointTurn::never},
    JointKind{JointType::slider, "slider", JointPlace::along_axis, JointTurn::never},
    JointKind{JointType::cylindrical, "cylindrical", JointPlace::along_axis, JointTurn::about_axis},
    JointKind{JointType::planar, "planar", JointPlace::in_plane, JointTurn::about_axis},
    JointKind{JointType::universal, "universal", JointPlace::together, JointTurn::about_two_axes},
    JointKind{JointType::screw, "screw", JointPlace::along_axis, JointTurn::about_axis, true},
    JointKind{JointType::gimbal, "gimbal", JointPlace::together, JointTurn::about_three_axes},
    JointKind{JointType::rectangular, "rectangular", JointPlace::in_plane, JointTurn::never},
    JointKind{JointType::offset_universal, "offset_universal", JointPlace::along_normal,
              JointTurn::about_two_axes},
};
static_assert([] {
  for (std::size_t i = 0; i < joint_kinds.size(); ++i)
    if (static_cast<std::size_t>(joint_kinds[i].type) != i) return false;
  return true;
}());

constexpr const JointKind& kind_of(JointType type) { return joint_kinds[static_cast<std::size_t>(type)]; }

}  // namespace cylon::core
