// Where two cores are nearest, or deepest in one another: the general algorithm behind every pair that has no
// formula of its own.
#pragma once

#include "engine/geometry/axis.h"
#include "engine/geometry/point_name.h"

#include <limits>

namespace cylon::engine {

/// In a's axes; without the rounding radii.
struct Touch {
  Real gap = 0;    ///< [m]
  Vector3 normal;  ///< Unit, from b to a.
  Vector3 a, b;    ///< a - b = gap normal, to rounding [m].
  PointName feature = 0;
  bool reached = false;  ///< By an axis, and points of both are `gap` apart along it.
};

/// If the two are farther apart than `far` [m], the gap may be any upper bound of theirs, with a normal to it.  `before`:
/// a touch of two that were nearly the same and lay nearly alike; it saves work alone.
Touch touch(const Couple&, Real far = std::numeric_limits<Real>::infinity(), const Touch* before = nullptr);

}  // namespace cylon::engine
