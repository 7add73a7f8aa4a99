// Who may touch whom, as MuJoCo has to know it: one coefficient for all or a list of pairs, and room for contacts.
// Knows no MuJoCo header.
#pragma once

#include "harness/core/scene.h"

#include <cstdint>
#include <vector>

namespace cylon::simulators {

/// A pair that may touch, and its coefficient of friction.
struct MujocoPair {
  core::Pair pair;
  double friction = 0;
};

struct MujocoContacts {
  /// Whether one coefficient holds for all pairs, and no groups and masks keep any apart.  Then the geoms have it, and
  /// MuJoCo's broad phase looks for pairs; else each pair is listed, and MuJoCo asks no other.  (Its own bits ask for one
  /// mask of the two, engine/engine_collision_driver.c:767.)
  bool uniform = true;
  double friction = 0;            ///< Where it is uniform.
  std::vector<MujocoPair> pairs;  ///< Where it is not.
  bool rubs = false;              ///< Some pair has friction.
  std::int64_t points = 0;        ///< Room for contact points at once.
};

/// Requires a material for each pair that may touch.
MujocoContacts mujoco_contacts(const core::Scene&);

/// What MuJoCo allocates for a scene with this room.  It grows with the square of the rows of constraints, 4 for a
/// contact, at most 6 for a joint that closes a loop and one for each stop and dry friction of a joint, and with the square
/// of the degrees of freedom.
struct MujocoMemory {
  double rows = 0;
  double buffer = 0;   ///< [bytes]
  double numbers = 0;  ///< Of its stack, 8 bytes each.

  double bytes() const { return buffer + 8 * numbers; }
};
MujocoMemory mujoco_memory(const core::Scene&, std::int64_t points);

}  // namespace cylon::simulators
