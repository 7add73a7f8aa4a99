#pragma once

#include "harness/core/scene.h"

namespace cylon::core {

/// World position of a point that is fixed in a body, or in the world [m].
inline Vector3 anchor(const State& state, int body, const Vector3& local) {
  if (body == world) return local;
  const BodyState& s = state[static_cast<std::size_t>(body)];
  return s.position + s.orientation * local;
}

}  // namespace cylon::core
