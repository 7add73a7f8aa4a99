// All bodies at an instant: how they move, and the forces on them but those of joints and contacts.
#pragma once

#include "engine/forces.h"

#include <vector>

namespace cylon::engine {

struct Loaded {
  std::vector<Kinematics> kinematics;
  std::vector<Load> loads;
};

/// One entry of each per body; `bodies` with their masses at `time`.
inline Loaded loaded(const Forces& forces, Time time, const std::vector<Body>& bodies,
                     const std::vector<Motion>& motions) {
  const std::size_t n = motions.size();
  Loaded result{{}, std::vector<Load>(n)};
  for (std::size_t i = 0; i < n; ++i)
    result.kinematics.push_back({motions[i].orientation.toRotationMatrix(), velocity(bodies[i], motions[i]),
                                 angular_velocity(bodies[i], motions[i])});
  apply(forces, time, bodies, n, motions.data(), result.kinematics.data(), result.loads.data());
  return result;
}

}  // namespace cylon::engine
