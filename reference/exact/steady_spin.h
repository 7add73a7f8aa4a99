// Rotation about an axis that keeps its direction, braked or not.
#pragma once

#include "reference/exact/wide.h"

namespace cylon::exact {

/// w = w0 exp(-r t), q = rot(w0 s) q0 with s = (1 - exp(-r t))/r, r = sum angular/I + momentum over the drags
/// of the body, I its moment about the axis of w0.
struct SteadySpin {
  WideQuaternion orientation;
  WideVector angular_velocity;
  Wide decay = 0;  ///< r [1/s]

  SteadySpin(const core::Scene&, std::size_t body);

  /// Fills in orientation and angular velocity.
  void turn(WideState& s, Wide t) const {
    const Wide past = decay == 0 ? t : -std::expm1(-decay * t) / decay;
    s.orientation = turn_by(angular_velocity, past) * orientation;
    s.angular_velocity = angular_velocity * std::exp(-decay * t);
  }
};

}  // namespace cylon::exact
