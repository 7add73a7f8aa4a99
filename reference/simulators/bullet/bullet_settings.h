// What may be set in Bullet and what each path sets, as words and numbers; knows no Bullet header.
#pragma once

#include "harness/core/engine.h"

#include <map>
#include <string>

namespace cylon::simulators {

/// One run's settings of Bullet, every default written out.
struct BulletSettings {
  std::string path;                      ///< "rigid", "rigid-bounce", "multibody", "as-shipped", "as-expert".
  bool multibody = false;                ///< btMultiBody in place of btRigidBody.
  std::string gyroscopic;                ///< "implicit-body", "implicit-world", "explicit" or "none".
  std::string solver;                    ///< "sequential-impulse", "nncg" or "dantzig".
  std::map<std::string, double> number;  ///< Every numeric option by its name.
  core::Terms terms;                     ///< The same for the reports.

  bool on(const char* option) const { return number.at(option) != 0; }
};

/// A contact threshold [m] at or beyond this is no limit; Bullet's BT_LARGE_FLOAT in single precision.
inline constexpr double no_limit = 1e18;

/// At this margin [m] a shape keeps Bullet's own, CONVEX_DISTANCE_MARGIN or less where the shape is small.
inline constexpr double default_margin = 0.04;

/// What Bullet says of itself.
core::Engine bullet_engine(std::string version, std::string precision);

/// What the paths look at in a scene.
struct BulletKind {
  bool touches = false;   ///< Some pair may touch.
  bool bounces = false;   ///< Some such pair has restitution > 0.
  double mass_ratio = 1;  ///< Of the heaviest moving body to the lightest.
  bool tree = false;  ///< Nothing touches; every moving body hangs from the world by joints of btMultiBody
                      ///< or has no gyroscopic torque; and no force but gravity and drag acts.
  int rk4_order = 4;  ///< Of rk4 on a tree: 4; 2 with ball joints, 1 with drag.
};

/// The settings of a setup on a scene of a kind.
/// Throws std::invalid_argument, naming the nearest valid one, for what bullet_engine() does not offer.
BulletSettings bullet_settings(const core::Engine&, const core::Setup&, const BulletKind&);

}  // namespace cylon::simulators
