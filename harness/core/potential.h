// Potential energies of forces, and bounds on their errors.  Each force says here whether it has a potential.
#pragma once

#include "harness/core/scene.h"
#include "harness/core/truth.h"

namespace cylon::core {

/// Sum of size(U_k) over the terms of the force's potential energy [J]; 0 for a force without a potential.
double potential(const Force&, const Scene&, const State&, double (*size)(double));

/// First-order bound on the error of the potential energy that an error of the state makes [J].
double potential_error(const Force&, const Scene&, const State&, const StateError&);

}  // namespace cylon::core
