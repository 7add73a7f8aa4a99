// Plugins of Gazebo by what their names say.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace cylon::formats {

/// Whether a system of gz-sim or a plugin of Gazebo pushes bodies without a command: by a medium, or to hold a target.
inline bool moves_bodies(std::string name) {
  constexpr std::array moving = {"buoyancy",   "hydrodynamics", "wind",      "lift-drag", "liftdrag",
                                 "lift_drag",  "controller",    "conveyor",  "lighter",   "multicopter",
                                 "trajectory", "thruster",      "track",     "mecanum",   "magnetic",
                                 "attract",    "apply_force",   "applylink", "detachable"};
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::ranges::any_of(moving, [&](const char* word) { return name.find(word) != std::string::npos; });
}

}  // namespace cylon::formats
