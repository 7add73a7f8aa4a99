// The rotation of a body on which no torque acts: exact over any time, exact over a short step, and split.
#pragma once

#include "engine/body.h"
#include "engine/elliptic.h"

#include <limits>

namespace cylon::engine {

/// The orientation at any time of a body that turns freely with constant angular momentum L.  With G = |L|, H
/// the energy, x_1 > x_2 > x_3 the inverse principal moments and l the angular momentum in principal axes,
///   l_i = A_i cn u,  l_j = s A_j sn u,  l_k = s A_k dn u,  u = lambda t + u_0,  s = sign l_k
///   A_i^2 = l_i^2 + l_j^2 (x_j - x_k)/(x_i - x_k),  A_j^2 = A_i^2 (x_i - x_k)/(x_j - x_k)
///   A_k^2 = l_k^2 + l_j^2 (x_i - x_j)/(x_i - x_k),  k^2 = A_i^2 (x_i - x_j)/(A_k^2 (x_j - x_k))
///   lambda = A_k sqrt((x_i - x_k)(x_j - x_k))
/// (i, j, k) = (1, 2, 3) where (x_1 - x_2) l_1^2 < (x_2 - x_3) l_3^2, else (3, 2, 1).  A principal axis e_p
/// turns about L by phi, phi' = G (2 H - x_p l_p^2)/(G^2 - l_p^2), so that with p = k where A_i > A_k
///   phi = G x_i t - G (x_i - x_j)(x_i - x_k)/((x_j - x_k) lambda) [J(u) - J(u_0)],  n = -(x_i - x_j)/(x_j -
///   x_k)
/// and else with p = i
///   phi = G x_k t + G (x_i - x_k) A_i^2/(A_k^2 lambda) [J(u) - J(u_0)],             n = -A_i^2/A_k^2
/// where J(u) = int_0^u sn^2/(1 - n sn^2) = sn^3/3 R_J(cn^2, dn^2, 1, 1 - n sn^2), -1 <= n <= 0: G^2 - l_p^2
/// is never below G^2/2.  E. T. Whittaker, Analytical Dynamics, section 69; L. D. Landau, E. M. Lifshitz,
/// Mechanics, section 37, with L in place of the velocities, which also serves a body that does not turn
/// about an axis (x = 0).  Symmetric bodies: exp(t x_2 L) R_0 exp(t (x_s - x_2) l_s e_s). The error is that
/// of rounding the phases u and phi: it grows as epsilon (u + phi), not with the number of calls.  Double in
/// both builds.
class FreeRotation {
 public:
  FreeRotation(const Body&, const Quaternion& orientation, const Vector3& angular_momentum);

  /// t of any sign [s].
  Quaternion at(Time t) const;

 private:
  using Rotation = Eigen::Quaternion<double, Eigen::DontAlign>;
  using Vector = Eigen::Vector3d;

  void set_up_asymmetric(const Vector& inverse);
  double phase_integral(const JacobiValues&) const;  // J for |u| <= K

  Rotation start_;        // R_0 P: principal axes to world; asymmetric: times the frame of l at t = 0
  Rotation to_body_;      // P^-1
  Vector l_;              // at t = 0, principal axes
  double magnitude_ = 0;  // G
  bool asymmetric_ = false;

  int axis_ = 0;                      // symmetric: s
  double precession_ = 0, spin_ = 0;  // G x_2, (x_s - x_2) l_s

  int i_ = 0, j_ = 1, k_ = 2, pole_ = 0;  // asymmetric
  Vector amplitude_;
  double lambda_ = 0, u_ = 0, phase_ = 0;  // u_0, J(u_0)
  double steady_ = 0, swing_ = 0, n_ = 0;  // phi = steady t + swing [J(u) - J(u_0)]
  double half_turn_ = 0;                   // J(K)
  Jacobi jacobi_;
};

/// As FreeRotation over a step h, for bodies without symmetry: Taylor series of l to rounding and Gauss
/// quadrature of phi' where the step is short, else FreeRotation itself.
Quaternion asymmetric_free_flow(const Body&, const Quaternion& orientation, const Vector3& angular_momentum,
                                Real h);

/// Whether two inverse moments are the same but for the rounding of the axes that they were found with.
inline bool same_moment(Real x, Real y) { return std::abs(x - y) <= 8 * epsilon * std::abs(y); }

/// The orientation after a time h with constant angular momentum L (world axes): exact to rounding for every
/// body and any h, made for short steps.  The drift of a splitting integrator.
inline Quaternion free_flow(const Body& body, const Quaternion& orientation, const Vector3& angular_momentum,
                            Real h) {
  const Vector3& x = body.inverse_moments;
  const bool low = same_moment(x[0], x[1]), high = same_moment(x[2], x[1]);
  if (!low && !high) return asymmetric_free_flow(body, orientation, angular_momentum, h);
  const Quaternion q = turned(orientation, h * x[1] * angular_momentum);
  if (low && high) return q;
  const int s = low ? 2 : 0;
  const Vector3 axis = body.principal_axes * Vector3::Unit(s);
  const Real spin = (x[s] - x[1]) * (orientation * axis).dot(angular_momentum);
  return renormalised(q * exponential(h * spin * axis));
}

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
