// The scenes of the repository as judges: which, and how long.
#pragma once

#include "harness/scenario/scenario.h"

#include <string>
#include <vector>

namespace cylon::mutants {

struct SceneRow {
  const char* name;     ///< Of the column.
  const char* file;     ///< Under the repository's root.
  double duration = 0;  ///< [s]; 0: as far as its theory goes, where it states one.
  double step = 0;      ///< [s]; 0: the scenario's.
};

const std::vector<SceneRow>& scene_rows();

/// A scenario cut to its duration, with every step or, of more than 1024, at most 256 samples a claim, and
/// what its claims allow.
struct Examined {
  scenario::Scenario scenario;
  std::vector<double> shipped;  ///< What each claim allows as it stands in its file.
};

/// Throws what the loader throws.
Examined examine(const SceneRow&);

}  // namespace cylon::mutants
