// Which pairs may overlap, without looking at all of them: a scene may have 10^5 spheres.
#pragma once

#include "harness/core/scene.h"

#include <optional>
#include <vector>

namespace cylon::core {

/// Radius of a sphere, 0 of a point [m]; nothing for any other shape.
std::optional<double> ball_radius(const Shape&);

/// Those of touching_pairs that may overlap, in the same order: every pair with a plane, and of two spheres
/// those in the same or in neighbouring cells of a grid.  All pairs where a body is no sphere or its place
/// not finite. O(bodies log bodies) where no spheres crowd, but O(bodies) for each that is over four times
/// the median radius.
std::vector<Pair> near_pairs(const Scene&, const State&);

}  // namespace cylon::core
