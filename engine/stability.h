// How long a step explicit integration of the forces may take.
#pragma once

#include "engine/forces.h"

#include <string>

namespace cylon::engine {

struct StepLimit {
  Real step = 0;  ///< Semi-implicit Euler is unstable in longer steps [s]; infinite where no force says so.
  std::string reason;  ///< The force that says so.
};

/// From the stiffness k and the damping c of each force alone, against the masses m that it moves:
///   h^2 k/m + 2 h c/m <= 4
/// (the eigenvalues of p'' = -(k p + c p')/m on the unit circle).  Other forces only shorten it: what is
/// longer is unstable wherever that force acts in full (water: on a body that is submerged), what is shorter
/// may be.
StepLimit longest_step(const Forces&, const std::vector<Body>&, Time);

/// A step in which explicit integration of all the forces together is stable and does not overshoot [s]: for each
/// body, with the sums over its forces of stiffness and damping per mass, k and c (a spring between two bodies
/// counts twice, levers count by the least moment of inertia),
///   h^2 k + h c <= 1.
/// By Gershgorin's bound on the eigenvalues.  Infinite where no force says so.  At a time: a frame may turn ever faster.
Real steady_step(const Forces&, const std::vector<Body>&, Time);

}  // namespace cylon::engine
