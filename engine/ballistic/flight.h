// How one body moves between two events.
#pragma once

#include "engine/body.h"

#include <algorithm>

namespace cylon::engine::ballistic {

inline constexpr int in_flight = -1;

/// p(t) = position + velocity s + acceleration s^2/2, s = t - since.  Each body has its own `since`, the last
/// event that changed it, so that no error grows with the number of steps.
struct alignas(64) Flight {
  Vector3 position, velocity;  ///< [m], [m/s]
  Time since = 0;              ///< [s]
  Real radius = 0;          ///< [m]; with what stands above, all that a meeting asks for, in one cache line.
  Vector3 acceleration;     ///< [m/s^2]
  int support = in_flight;  ///< The plane on which it rests, slides or rolls.
  unsigned changes = 0;     ///< How often its motion has changed.

  Vector3 position_at(Time t) const {
    const Real s = static_cast<Real>(t - since);
    return position + s * (velocity + s / 2 * acceleration);
  }
  Vector3 velocity_at(Time t) const { return velocity + static_cast<Real>(t - since) * acceleration; }

  void advance(Time t) {
    if (t == since) return;
    position = position_at(t);
    velocity = velocity_at(t);
    since = t;
  }
};

/// L(t) = angular_momentum + torque (t - since), world axes, about the centre of mass; the orientation is
/// known at `oriented`.
struct Turning {
  Quaternion orientation = Quaternion::Identity();
  Vector3 angular_momentum = Vector3::Zero(), torque = Vector3::Zero();  ///< [kg m^2/s], [N m]
  Time since = 0, oriented = 0;                                          ///< [s]

  bool turns() const { return !angular_momentum.isZero(0) || !torque.isZero(0); }
  Vector3 angular_momentum_at(Time t) const {
    return angular_momentum + static_cast<Real>(t - since) * torque;
  }
};

/// The orientation at a time t >= oriented.
Quaternion orientation_at(const Body&, const Turning&, Time t);

/// Takes `oriented` as near to t as whole strides of orientation_at lead, so that its cost does not grow with
/// the time since the last event.  Where the strides end depends on the motion alone, not on t.
void follow(const Body&, Turning&, Time t);

/// Makes t the time from which everything counts.
void turn_on(const Body&, Turning&, Time t);

}  // namespace cylon::engine::ballistic
