// What each path of Bullet sets, as a table.
#pragma once

#include "reference/simulators/bullet/bullet_settings.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

namespace cylon::simulators {

/// One setting of some paths where a scene is of a kind.
struct BulletRule {
  std::vector<std::string_view> paths;
  const char *option, *value;        ///< As a user gives them; "integrator" is one here.
  bool (*holds)(const BulletKind&);  ///< Null: always.
  const char* where;                 ///< The same in words; "" for always.
  const char* reason;

  bool of(std::string_view path) const { return std::ranges::find(paths, path) != paths.end(); }
  bool applies(const BulletKind& kind) const { return !holds || holds(kind); }
};

/// In the order in which they are reported.
std::span<const BulletRule> bullet_rules();

/// Whether the path "as-expert" takes btMultiBody.
bool expert_takes_multibody(const BulletKind&);

/// The same in words.
inline constexpr const char* expert_multibody =
    "btMultiBody with runge-kutta-4 where nothing touches, no force but gravity, drag and dampers of joints "
    "acts, every "
    "moving body hangs from the world by joints without stops and dry friction or has no gyroscopic torque, "
    "and masses "
    "are within a factor of 1000; else btRigidBody";

}  // namespace cylon::simulators
