// Between which bodies, and which of their points, a force acts.
#pragma once

#include "engine/vector.h"

#include <vector>

namespace cylon::engine {

/// The two ends of a force between two places.
struct Ends {
  int body = 0;
  Vector3 anchor = Vector3::Zero();  ///< Body axes, from the reference point [m].
  int to = fixed_world;
  Vector3 to_anchor = Vector3::Zero();  ///< Axes of `to`; world coordinates where `to` is the world [m].
  Real rest_length = 0;                 ///< [m]
};

/// The bodies that a force acts on; the world may be among them.
using Acted = std::vector<int>;

}  // namespace cylon::engine
