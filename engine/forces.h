// The forces that act without constraining: each adds its force and torque to the rates of its bodies.
#pragma once

#include "engine/body.h"

#include <vector>

namespace cylon::engine {

/// F = (stiffness (|d| - rest_length) + damping d|d|/dt) d/|d| on `body`, -F on `to`, at the anchors; d from
/// the anchor on `body` to the anchor on `to`.  Seed eq. 19 (errata 5), pull towards the pin (errata 47),
/// damping added. At |d| = 0 there is no direction and no force (errata 48).
struct Spring {
  int body = 0;
  Vector3 anchor = Vector3::Zero();  ///< Body axes [m].
  int to = fixed_world;
  Vector3 to_anchor = Vector3::Zero();  ///< Axes of `to`; world coordinates where `to` is the world [m].
  Real stiffness = 0;                   ///< [N/m], >= 0.
  Real rest_length = 0;                 ///< [m], >= 0.
  Real damping = 0;                     ///< [N s/m], >= 0.
};

/// F = -linear v, torque = -angular w - momentum L.  Seed eq. 20, without the factor dt of its program
/// (errata 49).
struct Drag {
  int body = 0;
  Real linear = 0;    ///< [kg/s], >= 0.
  Real angular = 0;   ///< [kg m^2/s], >= 0.
  Real momentum = 0;  ///< [1/s], >= 0.
};

/// F = force cos(frequency t) at the centre of mass.
struct Drive {
  int body = 0;
  Vector3 force = Vector3::Zero();  ///< World axes [N].
  Real frequency = 0;               ///< [rad/s]
};

/// All forces of a model; F = sum F_i, torque = sum r_i x F_i (seed eq. 57, 58).
struct Forces {
  Vector3 gravity = Vector3::Zero();  ///< F = m g on every body [m/s^2]; seed eq. 18 (errata 3).
  std::vector<Spring> springs;
  std::vector<Drag> drags;
  std::vector<Drive> drives;
};

/// Sets the force and torque of every rate; needs the velocities in it.
void apply(const Forces&, Real time, const std::vector<Body>&, const std::vector<Motion>&,
           std::vector<Rate>&);

}  // namespace cylon::engine
