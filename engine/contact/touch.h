// A point where surfaces touch, and how it moves.  Knows nothing of shapes, forces or time.
#pragma once

#include "engine/constraint.h"
#include "engine/model.h"

#include <cmath>
#include <optional>
#include <vector>

namespace cylon::engine {

/// A point of contact of `body` with `other`, or with the world.
///
/// Or a coordinate of a joint at its limit, or with dry friction: then `row` has its rate, the vectors here have axes
/// of their own, the normal is x, and the rate stands along x at a limit, along y where it is friction's.
struct TouchPoint {
  int body = 0;
  int other = fixed_world;
  Vector3 position = Vector3::Zero();  ///< World axes [m].
  Vector3 normal = Vector3::UnitY();   ///< n, unit, from `other` to `body`.
  Real restitution = 0;                ///< Newton's, [0, 1].
  Real friction = 0;                   ///< Coulomb's, >= 0.
  Real bound = 0;                     ///< The largest force of friction beside friction times the normal one.
  int pair = 0;                       ///< Points with the same number act at once.
  Real gap = 0;                       ///< g [m]; negative inside.
  Vector3 path = Vector3::Zero();     ///< dx/dt of the point itself, which need not be that of matter [m/s].
  Vector3 turning = Vector3::Zero();  ///< dn/dt [1/s].
  Real curvature = 0;                 ///< The part of d^2g/dt^2 that the velocities alone make [m/s^2].
  std::optional<Row> row;             ///< Of a coordinate.
  int axis = 0;                       ///< Along which it stands.
};

/// Whether an impulse changes the body's momentum: not where it is locked, or pinned (its reference point is
/// a pivot; only its angular momentum about that changes).
inline bool translates(const Body& body) { return !body.locked && body.inverse_mass > 0; }

/// Whether an impulse turns the body.
inline bool rotates(const Body& body) { return !body.locked && body.turns; }
inline Vector3 spin_of(const Body& body, const Motion& motion) {
  return rotates(body) ? angular_velocity(body, motion) : Vector3(Vector3::Zero());
}

/// Velocity of the body's matter at a point.  v + w x (x - p); errata 29.
inline Vector3 matter_velocity(const Body& body, const Motion& motion, const Vector3& point) {
  const Vector3 v = velocity(body, motion);
  return rotates(body) ? Vector3(v + angular_velocity(body, motion).cross(point - motion.position)) : v;
}

/// Velocity of the matter of `body` against that of `other` at the point [m/s]; of a coordinate its rate.
inline Vector3 relative_velocity(const TouchPoint& touch, const std::vector<Body>& bodies,
                                 const Motion* motion) {
  if (touch.row) return speed_of(*touch.row, bodies, motion) * Vector3::Unit(touch.axis);
  const std::size_t a = index(touch.body);
  Vector3 u = matter_velocity(bodies[a], motion[a], touch.position);
  if (touch.other != fixed_world) {
    const std::size_t b = index(touch.other);
    u -= matter_velocity(bodies[b], motion[b], touch.position);
  }
  return u;
}

/// Gives an impulse at a point of one body.  K += J, L += (x - p) x J; errata 25, 33.
inline void push(const Body& body, Motion& motion, const Vector3& point, const Vector3& impulse) {
  if (translates(body)) motion.momentum += impulse;
  if (rotates(body)) motion.angular_momentum += (point - motion.position).cross(impulse);
}

/// Gives the impulse J to `body` and -J to `other`.
inline void push(const TouchPoint& touch, const Vector3& impulse, const std::vector<Body>& bodies,
                 Motion* motion) {
  push(bodies[index(touch.body)], motion[index(touch.body)], touch.position, impulse);
  if (touch.other == fixed_world) return;
  push(bodies[index(touch.other)], motion[index(touch.other)], touch.position, -impulse);
}

}  // namespace cylon::engine
