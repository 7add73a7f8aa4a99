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

/// What a solution says of a scene.  A frame that does not turn and accelerates evenly is a gravity more, by which each
/// solution serves it (the principle of equivalence).  Throws core::OutOfDomain.
core::Truth solve(const Solution&, const core::Scene&, double horizon);

}  // namespace cylon::exact
