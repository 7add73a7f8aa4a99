#include "tests/mutants/matrix/seed/body.h"

#include <cmath>

namespace cylon::mutants::seed {
namespace {

// beta~ theta~ of eq. 77: the product of the pure quaternion beta with theta, in the order (x, y, z, w).
Eigen::Vector4d product(const Vector3& beta, const Quaternion& theta, Faults faulty) {
  const Vector3 v = beta * theta.w() + beta.cross(theta.vec());
  const double w = -beta.dot(theta.vec());
  if (faulty(20)) return {w, v.x(), v.y(), v.z()};
  return {v.x(), v.y(), v.z(), w};
}

// exp(beta / 2) theta.
Quaternion exactly(const Vector3& beta, const Quaternion& theta) {
  const double angle = beta.norm();
  // sin(a/2)/a = 1/2 - a^2/48 + …
  const double s = angle > 1e-4 ? std::sin(angle / 2) / angle : 0.5 - angle * angle / 48;
  Quaternion turn;
  turn.w() = std::cos(angle / 2);
  turn.vec() = s * beta;
  return (turn * theta).normalized();
}

// Eq. 76 and 78 as printed: theta + beta theta / 2.
Quaternion first_order(const Vector3& beta, const Quaternion& theta, Faults faulty) {
  return Quaternion(Eigen::Vector4d(theta.coeffs() + product(beta, theta, faulty) / 2));
}

// (1 + [beta]) R, scaled to det = 1, which is not enough for a rotation (errata 6).
Quaternion of_unit_determinant(const Vector3& beta, const Quaternion& theta) {
  Matrix3 r = theta.toRotationMatrix();
  for (int i = 0; i < 3; ++i) r.col(i) += beta.cross(r.col(i));
  r /= std::cbrt(r.determinant());
  return Quaternion(r);
}

}  // namespace

Matrix3 matrix_of(const Quaternion& q, Faults faulty) {
  const double t0 = q.x(), t1 = q.y(), t2 = q.z(), t3 = q.w();
  Matrix3 r;
  r(0, 0) = 2 * (t0 * t0 + (faulty(16) ? t1 * t1 : t3 * t3)) - 1;
  r(0, 1) = 2 * (t0 * t1 - t2 * t3);
  r(0, 2) = 2 * (t0 * t2 + (faulty(17) ? -t1 * t3 : t1 * t3));
  r(1, 0) = 2 * (t0 * t1 + t2 * t3);
  r(1, 1) = 2 * (t1 * t1 + t3 * t3) - 1;
  r(1, 2) = 2 * (t1 * t2 - t0 * t3);
  r(2, 0) = 2 * ((faulty(18) ? t0 * t3 : t0 * t2) - t1 * t3);
  r(2, 1) = 2 * (t0 * t3 + t1 * t2);
  r(2, 2) = 2 * (t2 * t2 + t3 * t3) - 1;
  return r;
}

void turn(Body& body, const Vector3& beta, double t, Faults faulty) {
  if (faulty(12)) return;                        // R_t = R(w dt) R_t
  if (faulty(45) && beta.norm() < 1e-5) return;  // PRECISION
  if (faulty(7))
    body.q = exactly(beta * t, body.q);  // R(theta t)
  else if (faulty(6))
    body.q = of_unit_determinant(beta, body.q);
  else if (faulty(20))
    body.q = first_order(beta, body.q, faulty).normalized();
  else if (faulty(21))
    body.q = first_order(beta, body.q, faulty);
  else if (faulty(19)) {  // eq. 76, "exact", for the whole turn so far
    body.turned += beta;
    body.q = first_order(body.turned, body.start, faulty);
  } else if (faulty(46)) {  // float, and not renormalised
    const Quaternion next = exactly(beta, body.q);
    const double norm = body.q.norm();
    for (int i = 0; i < 4; ++i) body.q.coeffs()[i] = static_cast<float>(next.coeffs()[i] * norm);
  } else {
    body.q = exactly(beta, body.q);
  }
}

Matrix3 inverse_inertia(const Body& body, Faults faulty) {
  if (faulty(42)) return body.inv_I;
  const Matrix3 R = matrix_of(body.q, faulty);
  if (faulty(61)) return R * body.inv_I * R.transpose();
  const Matrix3 M = R * body.I * R.transpose();
  if (M.isZero(0)) return Matrix3::Zero();
  Matrix3 inverse = M.inverse();
  // 1/Matrix of the listing: M(Z,Y) M(X,Y) in place of M(Z,X) M(X,Y).
  if (faulty(40)) inverse(2, 1) = (M(2, 1) * M(0, 1) - M(2, 1) * M(0, 0)) / M.determinant();
  return inverse;
}

void update_velocities(Body& body, Faults faulty) {
  body.v = body.inv_m * body.K;
  body.omega = inverse_inertia(body, faulty) * body.L;
}

}  // namespace cylon::mutants::seed
