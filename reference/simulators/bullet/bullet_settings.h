// What may be set in Bullet and what each path sets, as words and numbers; knows no Bullet header.
#pragma once

#include "harness/core/engine.h"

#include <map>
#include <string>

namespace cylon::simulators {

/// One run's settings of Bullet, every default written out.
struct BulletSettings {
  std::string path;                      ///< "rigid", "rigid-bounce" or "multibody".
  std::string gyroscopic;                ///< "implicit-body", "implicit-world", "explicit" or "none".
  std::string solver;                    ///< "sequential-impulse", "nncg" or "dantzig".
  std::map<std::string, double> number;  ///< Every numeric option by its name.
  core::Terms terms;                     ///< The same for the reports.

  bool multibody() const { return path == "multibody"; }
};

/// A contact threshold [m] at or beyond this is no limit; Bullet's BT_LARGE_FLOAT in single precision.
inline constexpr double no_limit = 1e18;

/// What Bullet says of itself.
core::Engine bullet_engine(std::string version, std::string precision);

/// The settings of a setup on a scene in which some touching pair bounces, or none does.
/// Throws std::invalid_argument, naming the nearest valid one, for what bullet_engine() does not offer.
BulletSettings bullet_settings(const core::Engine&, const core::Setup&, bool bounces);

}  // namespace cylon::simulators
