// The table of a scenario for many bodies that fly freely and never meet.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace cylon::bench {

/// `moments` [kg m^2] and `angular_velocity` [rad/s] as they stand in the file: "[0.2, 0.3, 0.4]".
inline std::string free_cloud(std::int64_t count, const std::string& moments,
                              const std::string& angular_velocity) {
  return fmt::format(R"([[cloud]]
name = "body"
seed = 1
count = {}
low = [-50, -50, -50]
high = [50, 50, 50]
speed = 1.0
mass = 1.5
inertia = {}
angular_velocity = {}
)",
                     count, moments, angular_velocity);
}

}  // namespace cylon::bench
