// A scene to look for faults in: what is run, and for how long.
#pragma once

#include "harness/core/scene.h"

#include <cstdint>
#include <string>

namespace cylon::hunt {

struct Trial {
  core::Scene scene;
  double step = 0.01;       ///< [s]
  std::int64_t steps = 60;  ///< >= 1
};

/// The text of a scenario file: the scene, a duration of `steps` steps, and `claims`, which is TOML.
std::string to_toml(const Trial&, const std::string& claims);

}  // namespace cylon::hunt
