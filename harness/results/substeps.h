// A step with the parts that an engine makes of it.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace cylon::results {

/// "1/60 (4 substeps)"; the step alone where it has one part, as nearly always.  Without a step "4 substeps", or nothing.
inline std::string with_substeps(std::string_view step, int substeps) {
  if (substeps == 1) return std::string(step);
  return step.empty() ? fmt::format("{} substeps", substeps)
                      : fmt::format("{} ({} substeps)", step, substeps);
}

}  // namespace cylon::results
