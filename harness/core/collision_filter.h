// Groups and masks: which things of a scene touch each other, as bits.
//
// Two things touch only if the mask of each has a group of the other (the rule of Bullet, Box2D, Jolt and Rapier;
// ODE's bits and MuJoCo's ask for one of the two).
#pragma once

#include "harness/core/scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::core {

/// The group of what names none.
inline constexpr std::string_view default_group = "default";

/// Of one scene, "default" among them: the bits of Bullet's filter.
inline constexpr std::size_t most_groups = 32;

/// Different pairs of groups and mask in one scene: what looks at all kinds of pairs stays below 10^5 of them.
inline constexpr std::size_t most_filters = 256;

/// One thing's groups and mask.
struct CollisionFilter {
  std::uint32_t groups = 1;  ///< Bit 0 is "default".
  std::uint32_t mask = ~std::uint32_t{0};
  // NOLINTNEXTLINE(modernize-use-nullptr): the literal that the compiler compares with
  friend auto operator<=>(const CollisionFilter&, const CollisionFilter&) = default;
};

constexpr bool may_meet(const CollisionFilter& a, const CollisionFilter& b) {
  return (a.groups & b.mask) != 0 && (b.groups & a.mask) != 0;
}

/// Those of a scene.  A name in a mask that no group has stands for nothing.
struct CollisionFilters {
  std::vector<CollisionFilter> of_body, of_plane;
  std::vector<std::string> names;  ///< Of the bits, from the lowest.
  bool stated = false;             ///< By anything that may touch.

  /// Throws std::invalid_argument where the scene has more than most_groups or most_filters.
  explicit CollisionFilters(const Scene&);
};

/// Whether the scene states groups or masks at all.
bool states_filters(const Scene&);

/// What keeps things apart whose surfaces could touch: both are locked, a joint ties them, or groups and masks.
/// Knows nothing of shapes and of `collide`; holds no reference to the scene.
class ContactRules {
 public:
  explicit ContactRules(const Scene&);

  bool bodies(int a, int b) const;
  bool body_and_plane(int body, int plane) const;

 private:
  std::vector<bool> locked_;
  std::vector<std::array<int, 2>> jointed_;  // ascending
  CollisionFilters filters_;
};

}  // namespace cylon::core
