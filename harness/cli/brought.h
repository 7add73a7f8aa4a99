// What a user brings along: engines, and plug-ins for engines.
#pragma once

#include <string>
#include <vector>

namespace cylon::cli {

struct Brought {
  std::vector<std::string> workers;  ///< NAME=COMMAND
  std::vector<std::string> plugins;  ///< NAME=FILE

  bool operator==(const Brought&) const = default;
};

}  // namespace cylon::cli
