// Force generators: each adds to F and tau of its bodies.
#pragma once

#include "tests/mutants/matrix/seed/body.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::mutants::seed {

struct Instant {
  double t = 0;        ///< [s]
  double dt = 0;       ///< Of the step [s]; no force knows it, but faulty ones.
  bool first = false;  ///< Whether no step was made yet.
};

/// Sets F and tau, from p, q, v, omega as they are.  Eq. 17-20, 57, 58; errata 2, 3, 5, 8, 22, 38, 47-51, 67.
void apply_forces(const core::Scene&, std::vector<Body>&, const Instant&, Faults);

/// Mass at time t; bodies that lose or gather any.  Eq. 11, 12.
void update_masses(const core::Scene&, std::vector<Body>&, double t);

/// Height of each body's centre over the water's surface, in the order of waters and bodies [m].
void heights_over_water(const core::Scene&, const std::vector<Body>&, double t, std::vector<double>&);

/// A force that this engine does not have.
std::optional<std::string> missing_force(const core::Scene&);

}  // namespace cylon::mutants::seed
