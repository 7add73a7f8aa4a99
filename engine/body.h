// What a rigid body is, how it moves, and how fast that changes.  Momentum form: p, K, R, L of the seed.
#pragma once

#include "engine/rotation.h"
#include "engine/vector.h"

namespace cylon::engine {

/// Constants of a rigid body.  Made by make_body, which keeps the inverses in step.
struct Body {
  Real mass = 1;                          ///< [kg], > 0.
  Matrix3 inertia = Matrix3::Identity();  ///< About the centre of mass, body axes [kg m^2].
  Real inverse_mass = 1;                  ///< [1/kg]; 0 when locked.
  Matrix3 inverse_inertia =
      Matrix3::Identity();                    ///< Body axes; 0 when locked and about an axis without inertia.
  Vector3 inverse_moments = Vector3::Ones();  ///< Principal, in ascending order of the moments.
  Quaternion principal_axes = Quaternion::Identity();  ///< Principal axes to body axes.
  bool locked = false;                                 ///< Infinite mass: does not move, whatever acts on it.
  bool turns = true;  ///< false: without spin, and nothing ever turns it; its orientation is left alone.
};

/// The state of one body.
struct Motion {
  Vector3 position = Vector3::Zero();               ///< p: centre of mass [m].
  Vector3 momentum = Vector3::Zero();               ///< K = m v [kg m/s]; seed eq. 11.
  Quaternion orientation = Quaternion::Identity();  ///< R: body to world, unit.
  Vector3 angular_momentum = Vector3::Zero();  ///< L = I w about the centre of mass, world axes [kg m^2/s].
};

/// The time derivative of a Motion.
struct Rate {
  Vector3 velocity;          ///< [m/s]
  Vector3 force;             ///< [N]
  Vector3 angular_velocity;  ///< World axes [rad/s].
  Vector3 torque;            ///< About the centre of mass, world axes [N m].
};

/// A body with its inverses.  Requires mass > 0 and a symmetric, positive semidefinite inertia; about an axis
/// without inertia (a thin rod's own) the body does not turn.
Body make_body(Real mass, const Matrix3& inertia, bool locked = false);

/// The motion that has the given velocities.  K = m v, L = R I R^T w; seed eq. 11, 55, 72.
Motion make_motion(const Body&, const Vector3& position, const Quaternion& orientation,
                   const Vector3& velocity, const Vector3& angular_velocity);

/// v = K / m; seed eq. 59.  0 when locked.
inline Vector3 velocity(const Body& body, const Motion& motion) {
  return body.inverse_mass * motion.momentum;
}

/// I^-1 x in world axes.  R I_0^-1 R^T x; seed eq. 72, which its program leaves out (errata 42).
inline Vector3 inverse_inertia_times(const Body& body, const Quaternion& orientation, const Vector3& x) {
  const Matrix3 r = orientation.toRotationMatrix();
  return r * (body.inverse_inertia * (r.transpose() * x));
}

/// w = R I_0^-1 R^T L, world axes; seed eq. 60, 72.  0 when locked.
inline Vector3 angular_velocity(const Body& body, const Motion& motion) {
  return inverse_inertia_times(body, motion.orientation, motion.angular_momentum);
}

}  // namespace cylon::engine
