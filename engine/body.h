// What a rigid body is, how it moves, and how fast that changes.  Momentum form: p, K, R, L of the seed.
#pragma once

#include "engine/rotation.h"
#include "engine/vector.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace cylon::engine {

/// Constants of a rigid body.  Made by make_body, which keeps the inverses in step.  Its reference point is
/// its centre of mass; of a body that is pinned to the world (engine/reduce.h) it is the pivot, and of one that
/// slides and turns on an axis a point of that.
struct Body {
  Real mass = 1;                          ///< [kg], > 0.
  Matrix3 inertia = Matrix3::Identity();  ///< About the reference point, body axes [kg m^2].
  Real inverse_mass = 1;                  ///< [1/kg]; 0 when locked or pinned.
  Matrix3 inverse_inertia =
      Matrix3::Identity();                    ///< Body axes; 0 when locked and about an axis without inertia.
  Vector3 inverse_moments = Vector3::Ones();  ///< Principal, in ascending order of the moments.
  Quaternion principal_axes = Quaternion::Identity();  ///< Principal axes to body axes.
  Vector3 centre = Vector3::Zero();  ///< Centre of mass from the reference point, body axes [m].
  Real mass_rate = 0;                ///< dm/dt [kg/s]; what enters or leaves does so at the centre of mass.
  bool locked = false;               ///< Infinite mass: does not move, whatever acts on it.
  bool pinned = false;               ///< Its reference point stays where it is; it only turns,
  bool one_axis = false;             ///< and that only about `axis`,
  Vector3 axis = Vector3::Zero();    ///< body axes, unit.
  std::optional<Matrix3>
      guide;          ///< A projection, world axes: its reference point only moves within its image.
  bool turns = true;  ///< false: without spin, and nothing ever turns it; its orientation is left alone.
  std::optional<Vector3> gravity;  ///< In place of that of all [m/s^2].
};

/// The state of one body: 13 Reals without gaps.
struct Motion {
  Vector3 position = Vector3::Zero();               ///< p: reference point [m].
  Vector3 momentum = Vector3::Zero();               ///< K = m v [kg m/s]; seed eq. 11.  0 when pinned.
  Quaternion orientation = Quaternion::Identity();  ///< R: body to world, unit.
  Vector3 angular_momentum = Vector3::Zero();  ///< L = I w about the reference point, world axes [kg m^2/s].
};

inline constexpr std::size_t motion_size = 13;
static_assert(sizeof(Motion) == motion_size * sizeof(Real));

/// What follows from a Motion and is used many times.
struct Kinematics {
  Matrix3 rotation;          ///< R, body to world.
  Vector3 velocity;          ///< Of the reference point [m/s].
  Vector3 angular_velocity;  ///< World axes [rad/s].
};

/// The sum of what acts on one body.
struct Load {
  Vector3 force = Vector3::Zero();   ///< [N]
  Vector3 torque = Vector3::Zero();  ///< About the reference point, world axes [N m].
};

/// A body with its inverses.  Requires mass > 0 and a symmetric, positive semidefinite inertia; about an axis
/// without inertia (a thin rod's own) the body does not turn.
Body make_body(Real mass, const Matrix3& inertia, bool locked = false);

/// m a of the reference point under a load [N]: K' = F and K = m v, so m a = F - m' v.
inline Vector3 accelerating(const Body& body, const Kinematics& k, const Load& load) {
  return body.mass_rate == 0 ? load.force : Vector3(load.force - body.mass_rate * k.velocity);
}

/// Bodies from this one on are locked.
inline std::size_t movable_end(const std::vector<Body>& bodies) {
  std::size_t end = bodies.size();
  while (end > 0 && bodies[end - 1].locked) --end;
  return end;
}

/// The motion that has the given velocities.  K = m v, L = R I R^T w; seed eq. 11, 55, 72.
Motion make_motion(const Body&, const Vector3& position, const Quaternion& orientation,
                   const Vector3& velocity, const Vector3& angular_velocity);

/// v = K / m; seed eq. 59.  0 when locked.
inline Vector3 velocity(const Body& body, const Motion& motion) {
  return body.inverse_mass * motion.momentum;
}

/// I^-1 x in world axes.  R I_0^-1 R^T x; seed eq. 72, which its program leaves out (errata 42).
inline Vector3 inverse_inertia_times(const Body& body, const Matrix3& r, const Vector3& x) {
  return r * (body.inverse_inertia * (r.transpose() * x));
}
inline Vector3 inverse_inertia_times(const Body& body, const Quaternion& orientation, const Vector3& x) {
  return inverse_inertia_times(body, orientation.toRotationMatrix(), x);
}

/// w = R I_0^-1 R^T L, world axes; seed eq. 60, 72.  0 when locked.
inline Vector3 angular_velocity(const Body& body, const Motion& motion) {
  return inverse_inertia_times(body, motion.orientation, motion.angular_momentum);
}

}  // namespace cylon::engine
