// The forces that act without constraining: each adds its force and torque to the loads of its bodies.
#pragma once

#include "engine/body.h"
#include "engine/water.h"

#include <vector>

namespace cylon::engine {

/// F = (stiffness (|d| - rest_length) + damping d|d|/dt) d/|d| on `body`, -F on `to`, at the anchors; d from
/// the anchor on `body` to the anchor on `to`.  Seed eq. 19 (errata 5), pull towards the pin (errata 47),
/// damping added.  At |d| = 0 there is no direction and no force (errata 48).
struct Spring {
  int body = 0;
  Vector3 anchor = Vector3::Zero();  ///< Body axes, from the reference point [m].
  int to = fixed_world;
  Vector3 to_anchor = Vector3::Zero();  ///< Axes of `to`; world coordinates where `to` is the world [m].
  Real stiffness = 0;                   ///< [N/m], >= 0.
  Real rest_length = 0;                 ///< [m], >= 0.
  Real damping = 0;                     ///< [N s/m], >= 0.
};

/// F = -linear v at the centre of mass, torque = -angular w - momentum L_spin.  Seed eq. 20, without the
/// factor dt of its program (errata 49).
struct Drag {
  int body = 0;
  Real linear = 0;    ///< [kg/s], >= 0.
  Real angular = 0;   ///< [kg m^2/s], >= 0.
  Real momentum = 0;  ///< [1/s], >= 0.
};

/// A constant force in body axes at the centre of mass, or exchanged mass: dm/dt = Body::mass_rate brings in
/// the momentum mass_rate (v + R exhaust) where the velocity of the exchanged mass is given relative to the
/// body, or mass_rate exchanged where it is given in world axes.  dK/dt = F + (dm/dt) v_exchanged: seed eq.
/// 12 with the term that it leaves out (errata 2).
struct Thrust {
  int body = 0;
  Vector3 force = Vector3::Zero();  ///< Body axes [N].
  Real mass_rate = 0;               ///< [kg/s]; its part of Body::mass_rate.
  bool relative = false;  ///< `exchanged` is relative to the body, in body axes; else in world axes.
  Vector3 exchanged = Vector3::Zero();  ///< [m/s]
};

/// F = force cos(frequency t) at the centre of mass.
struct Drive {
  int body = 0;
  Vector3 force = Vector3::Zero();  ///< World axes [N].
  Real frequency = 0;               ///< [rad/s]
};

/// F = strength m_a m_b d/|d|^3 on `body`, -F on `to`, d from `body` to `to`, between centres of mass.  At
/// |d| = 0 there is no direction and no force.
struct Attraction {
  int body = 0;
  int to = 0;
  Real strength = 0;  ///< [m^3/(kg s^2)]
};

/// All forces of a model; F = sum F_i, torque = sum r_i x F_i (seed eq. 17, 57, 58; errata 4).
struct Forces {
  Vector3 gravity = Vector3::Zero();  ///< F = m g on every body [m/s^2]; seed eq. 18 (errata 3).
  std::vector<Spring> springs;
  std::vector<Drag> drags;
  std::vector<Thrust> thrusts;
  std::vector<Drive> drives;
  std::vector<Attraction> attractions;
  std::vector<Water> waters;

  /// Gravity, then one per row above, in that order.
  std::size_t count() const {
    return 1 + springs.size() + drags.size() + thrusts.size() + drives.size() + attractions.size() +
           waters.size();
  }
  bool only_gravity() const { return count() == 1; }
  /// Whether any of them reads a velocity; all such are affine in the momenta.
  bool read_velocities() const;
};

/// Sets the loads.  Arrays have one entry per body.  `powers`, if any, has count() entries and gets the power
/// of each force [W]: F.v + torque.w, the integrand of seed eq. 84 (errata 23).
void apply(const Forces&, Time, const std::vector<Body>&, const Motion*, const Kinematics*, Load*,
           Real* powers = nullptr);

}  // namespace cylon::engine
