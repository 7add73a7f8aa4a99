#include "engine/body.h"

#include <Eigen/Eigenvalues>
#include <cassert>

namespace cylon::engine {

namespace {

// A moment below this part of the largest is none: 1e-12 is what a flat or thin shape's sum rounds to.
constexpr Real no_moment = static_cast<Real>(1e-12);

}  // namespace

Body make_body(Real mass, const Matrix3& inertia, bool locked) {
  assert(mass > 0);
  Body body;
  body.mass = mass;
  body.inertia = inertia;
  body.locked = locked;
  body.inverse_mass = locked ? 0 : 1 / mass;

  const Eigen::SelfAdjointEigenSolver<Matrix3> principal(inertia);
  Matrix3 axes = principal.eigenvectors();
  if (axes.determinant() < 0) axes.col(2) = -axes.col(2);
  body.principal_axes = Quaternion(axes).normalized();

  const Vector3& moments = principal.eigenvalues();
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
    body.inverse_inertia = axes * body.inverse_moments.asDiagonal() * axes.transpose();
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
