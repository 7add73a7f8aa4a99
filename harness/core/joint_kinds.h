// The kinds of joints, one row each: what a joint keeps of the motion of its two bodies against each other.
// A kind of known keeps is one row; whoever writes equations switches over the keeps, and a new keep does not
// compile there.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace cylon::core {

enum class JointType { ball, hinge, distance, fixed };

/// What a joint keeps of the two points that it joins.
enum class JointPlace {
  together,  ///< They coincide.
  at_length  ///< Their distance is `length`.  The points are centres of mass, or one is a point of the world.
};

/// How the two bodies of a joint may turn against each other.
enum class JointTurn {
  freely,
  about_axis,  ///< Only about `axis`, which is fixed in both.
  never
};

struct JointKind {
  JointType type;
  std::string_view name;  ///< In files and between processes.
  JointPlace place;
  JointTurn turn;

  constexpr bool has_axis() const { return turns_about_axis(); }
  /// Joins the centres of mass, or one and a point of the world; else both bodies at one point.
  constexpr bool joins_centres() const { return place == JointPlace::at_length; }
  constexpr bool has_length() const { return place == JointPlace::at_length; }
  /// The one rotation that is left is about the axis.
  constexpr bool turns_about_axis() const { return turn == JointTurn::about_axis; }
};

inline constexpr std::array joint_kinds = {
    JointKind{JointType::ball, "ball", JointPlace::together, JointTurn::freely},
    JointKind{JointType::hinge, "hinge", JointPlace::together, JointTurn::about_axis},
    JointKind{JointType::distance, "distance", JointPlace::at_length, JointTurn::freely},
    JointKind{JointType::fixed, "fixed", JointPlace::together, JointTurn::never},
};
static_assert([] {
  for (std::size_t i = 0; i < joint_kinds.size(); ++i)
    if (static_cast<std::size_t>(joint_kinds[i].type) != i) return false;
  return true;
}());

constexpr const JointKind& kind_of(JointType type) { return joint_kinds[static_cast<std::size_t>(type)]; }

}  // namespace cylon::core
