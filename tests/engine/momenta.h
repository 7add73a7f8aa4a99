// Momentum and angular momentum of all bodies.
#pragma once

#include "engine/body.h"

#include <vector>

namespace cylon::engine {

inline Vector3 momentum(const std::vector<Motion>& motions) {
  Vector3 sum = Vector3::Zero();
  for (const Motion& m : motions) sum += m.momentum;
  return sum;
}

/// About the world origin: sum p x K + L.
inline Vector3 angular_momentum(const std::vector<Motion>& motions) {
  Vector3 sum = Vector3::Zero();
  for (const Motion& m : motions) sum += m.position.cross(m.momentum) + m.angular_momentum;
  return sum;
}

}  // namespace cylon::engine
