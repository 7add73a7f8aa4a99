// What an impact does to the velocities and spins of two spheres, or of one and a plane.
#pragma once

#include "engine/ballistic/flight.h"
#include "engine/model.h"

#include <cmath>

namespace cylon::engine::ballistic {

/// One of the two that meet.  The unmoved world is the default.
struct Side {
  Real inverse_mass = 0, inverse_inertia = 0, radius = 0;
  Vector3 velocity = Vector3::Zero(), angular_momentum = Vector3::Zero();

  /// 1/m + r^2/I: how much a tangential impulse moves the surface [1/kg].
  Real tangential() const { return inverse_mass + inverse_inertia * radius * radius; }
  /// r w
  Vector3 rim() const { return radius * inverse_inertia * angular_momentum; }
  void push(const Vector3& impulse) { velocity += inverse_mass * impulse; }
  /// The same where the sphere is touched at -r n; it turns by the tangential part alone.
  void rub(const Vector3& tangential, const Vector3& n) {
    push(tangential);
    angular_momentum -= radius * n.cross(tangential);
  }
};

/// Velocity of the surface of a against that of b where they touch; n from b to a.
///   u = v_a - v_b - (r_a w_a + r_b w_b) x n
inline Vector3 slip(const Side& a, const Side& b, const Vector3& n) {
  return a.velocity - b.velocity - (a.rim() + b.rim()).cross(n);
}

/// The tangential impulse on a for a normal impulse J_n >= 0: what ends the slip, but no more than friction
/// allows.  With k = 1/m_a + r_a^2/I_a + 1/m_b + r_b^2/I_b and the tangential slip u,
///   J_t = -u/k where |u|/k <= mu J_n (sticks; solid sphere on a plane: 1/k = 2m/7), else -mu J_n u/|u|
/// Coulomb's law in place of seed eq. 93 (errata 30, 31); normal and tangential parts do not mix because the
/// arms of spheres are along the normal (errata 32).
inline Vector3 friction_impulse(const Vector3& slip, const Vector3& n, Real k, Real mu, Real normal_impulse) {
  const Vector3 u = slip - n.dot(slip) * n;
  const Real speed = u.norm();
  if (speed <= mu * normal_impulse * k) return -u / k;
  return -(mu * normal_impulse / speed) * u;
}

/// Newton's law with restitution e, then friction.  J_n = -(1 + e) n.(v_a - v_b) / (1/m_a + 1/m_b): seed eq.
/// 92 (errata 24 to 29).  Requires that they approach, and that one of them can move.
inline void strike(Side& a, Side& b, const Vector3& n, const Material& material) {
  const Real normal =
      -(1 + material.restitution) * n.dot(a.velocity - b.velocity) / (a.inverse_mass + b.inverse_mass);
  a.push(normal * n);
  b.push(-normal * n);
  if (material.friction > 0) {
    const Real k = a.tangential() + b.tangential();
    const Vector3 tangential = friction_impulse(slip(a, b, n), n, k, material.friction, normal);
    a.rub(tangential, n);
    b.rub(-tangential, -n);
  }
}

}  // namespace cylon::engine::ballistic
