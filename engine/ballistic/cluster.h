// Impacts of several contacts at one instant, all at once.
#pragma once

#include "engine/ballistic/impact.h"

#include <vector>

namespace cylon::engine::ballistic {

/// A contact that takes part.  Indices into the sides.
struct Touch {
  int a = 0, b = 0;
  int body = 0, other = -1, plane = -1;  ///< Which of the model's they are; other = -1: not a body.
  Vector3 n;                             ///< From b to a.
  Material material;
  Real approach = 0;  ///< -u-, or 0 where they part [m/s].
  bool ends = false;  ///< The last of ever shorter bounces.
  Real wanted = 0;    ///< Separation speed that Newton's law asks for: -e min(u-, 0) [m/s].
  Real normal = 0;    ///< J_n [N s]
  Vector3 tangential = Vector3::Zero();  ///< J_t [N s]
};

/// Changes the sides so that for every contact  u+ - wanted >= 0, J_n >= 0, (u+ - wanted) J_n = 0, with
/// Coulomb's cone |J_t| <= mu J_n.  Projected Gauss-Seidel until no impulse changes by more than rounding;
/// the velocities are unique without friction, whatever the order of the contacts (the matrix of the problem
/// is positive semidefinite: R. W. Cottle, J.-S. Pang, R. E. Stone, The Linear Complementarity Problem, 1992,
/// theorem 3.1.7).  Returns false where it did not settle.
bool strike_at_once(std::vector<Touch>&, std::vector<Side>&);

}  // namespace cylon::engine::ballistic
