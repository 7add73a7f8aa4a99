// The exact solutions by name: a row for each file of this folder.
#pragma once

#include "harness/core/truth.h"

#include <span>
#include <string_view>

namespace cylon::exact {

struct Solution {
  std::string_view name;                                    ///< As in `follows = "..."`.
  core::Truth (*make)(const core::Scene&, double horizon);  ///< Throws core::OutOfDomain.
  std::string_view domain;                                  ///< One line: which scenes it serves.
};

/// All solutions, by name.
std::span<const Solution> catalogue();

}  // namespace cylon::exact
