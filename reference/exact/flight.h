// The free motion of one body: its centre of mass falls, its spin keeps its axis.
#pragma once

#include "reference/exact/wide.h"

namespace cylon::exact {

/// p = p0 + v0 t + g t^2/2, v = v0 + g t, q = rot(w t) q0, w constant.
/// The orientation is right for bodies that turn about a principal axis; others replace it.
struct Flight {
  WideVector position, velocity, acceleration, angular_velocity;
  WideQuaternion orientation;

  Flight(const core::BodyState& s, const core::Vector3& gravity)
      : position(widen(s.position)),
        velocity(widen(s.velocity)),
        acceleration(widen(gravity)),
        angular_velocity(widen(s.angular_velocity)),
        orientation(widen(s.orientation)) {}

  WideState at(Wide t) const {
    return {.position = position + velocity * t + acceleration * (t * t / 2),
            .velocity = velocity + acceleration * t,
            .angular_velocity = angular_velocity,
            .orientation = turn_by(angular_velocity, t) * orientation};
  }
};

}  // namespace cylon::exact
