// The rotation of a body on which no torque acts, explicit and symplectic.
#pragma once

#include "engine/body.h"

namespace cylon::engine {

/// How the parts of a Hamiltonian that do not commute are composed.
enum class Splitting {
  lie,    ///< H_a(h) H_c(h): first order.
  strang  ///< H_a(h/2) H_c(h) H_a(h/2): second order, reversible.
};

/// The orientation after a time h with constant angular momentum L (world axes).  With principal moments a <=
/// b <= c,
///   H = |L|^2/2b + (1/a - 1/b) L_a^2/2 + (1/c - 1/b) L_c^2/2 = H_b + H_a + H_c
/// H_b turns the body about L at |L|/b and commutes with the others; H_a and H_c turn it about its own axes a
/// and c. Symplectic: the energy error stays bounded.  Exact for symmetric bodies, where H_a or H_c is zero.
/// J. Touma, J. Wisdom, Lie-Poisson integrators for rigid body dynamics in the solar system, Astron. J. 107
/// (1994) 1189, section 3.  Replaces seed eq. 60, 63.
inline Quaternion free_rotation(const Body& body, const Quaternion& orientation,
                                const Vector3& angular_momentum, Real h, Splitting splitting) {
  const Vector3& inverse = body.inverse_moments;
  const Quaternion q = turned(orientation, h * inverse[1] * angular_momentum);
  if (inverse[0] == inverse[1] && inverse[2] == inverse[1]) return q;

  Quaternion principal = q * body.principal_axes;
  Vector3 l = principal.conjugate() * angular_momentum;  // in principal axes
  const auto twist = [&](int axis, Real time) {
    const Real rate = (inverse[axis] - inverse[1]) * l[axis];
    if (rate == 0) return;
    const Quaternion turn = exponential(time * rate * Vector3::Unit(axis));
    principal = principal * turn;
    l = turn.conjugate() * l;
  };
  if (splitting == Splitting::lie) {
    twist(0, h);
    twist(2, h);
  } else {
    twist(0, h / 2);
    twist(2, h);
    twist(0, h / 2);
  }
  return renormalised(principal * body.principal_axes.conjugate());
}

}  // namespace cylon::engine
