#include "engine/body.h"

#include "engine/eigen3.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace cylon::engine {

namespace {

// A moment below this part of the largest is none.  A turn about it comes from an angular momentum that is
// rounded to epsilon L: at 1e-13 to 2e-3 of the fastest turn, and in single precision, where the rounding of a
// turned tensor, 16 epsilon at most, is more, to 6e-2.
constexpr Real no_moment = std::max(static_cast<Real>(1e-13), 16 * epsilon);

// R D R^T, symmetric to the bit; written out, so that every compiler sums in the same order.
Matrix3 in_axes(const Matrix3& r, const Vector3& d) {
  Matrix3 result;
  for (int i = 0; i < 3; ++i) {
    for (int k = i; k < 3; ++k) {
      const Real sum = r(i, 0) * d[0] * r(k, 0) + r(i, 1) * d[1] * r(k, 1) + r(i, 2) * d[2] * r(k, 2);
      result(i, k) = sum;
      result(k, i) = sum;
    }
  }
  return result;
}

}  // namespace

Body make_body(Real mass, const Matrix3& inertia, bool locked) {
  assert(mass > 0);
  Body body;
  body.mass = mass;
  body.inertia = inertia;
  body.locked = locked;
  body.inverse_mass = locked ? 0 : 1 / mass;

  const auto [moments, axes] = principal(inertia);
  body.principal_axes = Quaternion(axes).normalized();
  for (int i = 0; i < 3; ++i) {
    const bool turns = !locked && moments[i] > no_moment * moments[2];
    body.inverse_moments[i] = turns ? 1 / moments[i] : 0;
  }
  if (inertia.isDiagonal(0)) {  // no rounding through the eigenvectors
    body.inverse_inertia.setZero();
    for (int i = 0; i < 3; ++i) {
      const bool turns = !locked && inertia(i, i) > no_moment * moments[2];
      body.inverse_inertia(i, i) = turns ? 1 / inertia(i, i) : 0;
    }
  } else {
    body.inverse_inertia = in_axes(axes, body.inverse_moments);
  }
  return body;
}

Motion make_motion(const Body& body, const Vector3& position, const Quaternion& orientation,
                   const Vector3& velocity, const Vector3& angular_velocity) {
  Motion motion;
  motion.position = position;
  motion.orientation = orientation.normalized();
  const Matrix3 r = motion.orientation.toRotationMatrix();
  motion.momentum = body.mass * velocity;
  motion.angular_momentum = r * (body.inertia * (r.transpose() * angular_velocity));
  return motion;
}

}  // namespace cylon::engine
