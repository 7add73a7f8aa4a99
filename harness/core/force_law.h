// The mechanics of forces for those who judge motion: potential energies, and which laws and symmetries
// each force leaves intact.
#pragma once

#include "harness/core/scene.h"
#include "harness/core/truth.h"

#include <vector>

namespace cylon::core {

/// Why a law or a symmetry of mechanics does not hold where a force acts, in words; null where it holds.
/// What a force does not state does not hold.
struct Broken {
  static constexpr const char* unstated = "a force acts of which nobody has stated this";

  const char* energy = unstated;         ///< The work comes from a potential that does not depend on time.
  const char* momentum = unstated;       ///< It acts between bodies of the scene: both momenta are conserved.
  const char* reversal = unstated;       ///< The motion may run backwards.
  const char* any_instant = unstated;    ///< It is the same at all times, and so are masses.
  const char* boost = unstated;          ///< It is the same for bodies with a common velocity, at any place.
  const char* free_fall = unstated;      ///< It is the same for bodies that fall together.
  const char* restatement = unstated;    ///< It has no place, axes or units of its own.
  const char* superposition = unstated;  ///< It is affine in places and velocities of centres.
};

/// One entry for each force of the scene, in their order, and one for gravities that bodies have of their own.
std::vector<Broken> broken_by(const Scene&);

/// Sum of size(U_k) over the terms of the force's potential energy [J]; 0 for a force without a potential.  Gravity's
/// is that of bodies without one of their own.
double potential(
    const Force&, const Scene&, const State&, double (*size)(double) = [](double u) { return u; });

/// The same of the gravities that bodies have of their own.
double own_gravity_potential(
    const Scene&, const State&, double (*size)(double) = [](double u) { return u; });

/// Of all forces of the scene, and of gravities that bodies have of their own.
double potential_total(
    const Scene&, const State&, double (*size)(double) = [](double u) { return u; });

/// First-order bound on the error of potential_total that an error of the state makes [J].
double potential_error_total(const Scene&, const State&, const StateError&);

/// v^2 that the force alone gives over a length, roughly [m^2/s^2]; 0 where it has no scale of its own.
double squared_speed(const Force&, const Scene&, double length);

}  // namespace cylon::core
