// The scenes of the repository as judges: which, how long, and how fast they go.
#pragma once

#include "harness/scenario/scenario.h"

#include <map>
#include <string>
#include <vector>

namespace cylon::mutants {

enum class Forces {
  smooth,
  kinked,  ///< Friction changes its law within a step: no order shows, though the bound holds.
  jumping  ///< An integrator of fixed steps is of first order.
};

struct SceneRow {
  const char* name;          ///< Of the column.
  const char* file;          ///< Under the repository's root.
  double duration;           ///< [s]; 0: the whole scenario.
  double rate;               ///< The motion's fastest rate Omega [1/s].
  const char* why;           ///< Where the rate comes from, and the magnification where it is not 1.
  double magnification = 1;  ///< What the motion itself makes of an error.
  double step = 0;           ///< [s]; 0: the scenario's.
  Forces forces = Forces::smooth;
};

const std::vector<SceneRow>& scene_rows();

/// A scenario cut to its duration, with at most 256 samples a claim, and what its claims allow.
struct Examined {
  scenario::Scenario scenario;
  SceneRow row;
  std::vector<double> shipped;  ///< What each claim allows as it stands in its file.
  std::vector<double> scales;   ///< Size of each claim's quantity, > 0.
};

/// Throws what the loader throws.
Examined examine(const SceneRow&);

}  // namespace cylon::mutants
