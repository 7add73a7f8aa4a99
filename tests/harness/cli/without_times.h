// A report of a run without what differs each time.
#pragma once

#include <sstream>
#include <string>
#include <utility>

namespace cylon::cli {

inline std::string without_times(std::string text) {
  std::string kept;
  for (std::istringstream lines(std::move(text)); std::getline(lines, text);) {
    if (text.starts_with("\"provenance\"")) continue;
    const auto at = text.find("\"cpu_seconds\"");
    kept +=
        at == std::string::npos ? text : text.substr(0, at) + text.substr(text.find("\"body_steps\"", at));
    kept += '\n';
  }
  return kept;
}

}  // namespace cylon::cli
