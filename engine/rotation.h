// Finite rotations: the exponential map, its inverse derivative, and how an orientation is turned.
// Knows nothing of bodies.
#pragma once

#include "engine/vector.h"

#include <cmath>

namespace cylon::engine {

/// The rotation by a vector b (axis times angle, rad).  exp(b) = (cos |b|/2, b/|b| sin |b|/2).
/// Any b; exact to rounding.  Seed eq. 73 in the order (w, x, y, z), and eq. 76 replaced by the exponential
/// that it is the first order of (errata 19, 20).  Small angles take the series of sin x / x, so that no
/// rotation is too small to count (errata 45).
inline Quaternion exponential(const Vector3& b) {
  const Real xx = b.squaredNorm() / 4;  // x = |b|/2
  Real cosine = 1, sinc = 1;
  if (xx < 0.01) {  // first term left out: x^10/10! < 3e-17
    cosine = 1 - xx / 2 * (1 - xx / 12 * (1 - xx / 30 * (1 - xx / 56)));
    sinc = 1 - xx / 6 * (1 - xx / 20 * (1 - xx / 42 * (1 - xx / 72)));
  } else {
    const Real x = std::sqrt(xx);
    cosine = std::cos(x);
    sinc = std::sin(x) / x;
  }
  const Vector3 v = sinc / 2 * b;
  return {cosine, v.x(), v.y(), v.z()};
}

/// The matrix of the rotation by q/|q|, of any length above 0: exactly the same for all multiples of q, as
/// the stages of an integrator make them.  Seed eq. 74 (errata 16-18) with 2/|q|^2 in place of 2.
inline Matrix3 rotation_matrix(const Quaternion& q) {
  const Real s = 2 / q.squaredNorm();
  const Real w = q.w(), x = q.x(), y = q.y(), z = q.z();
  Matrix3 r;
  r << 1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y),  //
      s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x),   //
      s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y);
  return r;
}

/// The unit quaternion next to q.  q (3 - |q|^2)/2, one Newton step for q/|q|.
/// Exact to rounding for | |q| - 1 | < 1e-8, which is where a product of unit quaternions is (errata 21, 46).
inline Quaternion renormalised(const Quaternion& q) {
  return Quaternion(q.coeffs() * ((3 - q.squaredNorm()) / 2));
}

/// An orientation R turned by b, world axes [rad].  R' = exp(b) R; seed eq. 33, 63 (errata 12).
inline Quaternion turned(const Quaternion& orientation, const Vector3& b) {
  return renormalised(exponential(b) * orientation);
}

/// du/dt for R = exp(u) R_0 turning with angular velocity w (world axes).
///   dexp^-1_u w = w - (u x w)/2 + (1/12 + |u|^2/720 + |u|^4/30240 + ...) u x (u x w)
/// Domain |u| < 2 pi; the first term left out is |u|^8 |w| / 1.2e6.  A. Iserles et al., Lie-group methods,
/// Acta Numerica 9 (2000), section 2.4, eq. (2.42).
inline Vector3 inverse_dexp(const Vector3& u, const Vector3& w) {
  const Real uu = u.squaredNorm();
  const Vector3 cross = u.cross(w);
  return w - cross / 2 + (Real(1) / 12 + uu * (Real(1) / 720 + uu / 30240)) * u.cross(cross);
}

}  // namespace cylon::engine
