// The nearest points of two convex polytopes that are apart.
#pragma once

#include "engine/geometry/core.h"
#include "engine/geometry/point_name.h"

namespace cylon::engine {

/// In a's axes.
struct Nearest {
  Vector3 a, b;           ///< The points [m].
  Vector3 normal;         ///< Unit, from b to a; undefined where they overlap.
  Real distance = 0;      ///< |a - b| [m]; 0 where they overlap or are within rounding of it.
  PointName feature = 0;  ///< Of the vertices that the points are between.
  bool is_far = false;
};

/// The algorithm of Gilbert, Johnson and Keerthi (IEEE J. Robotics and Automation 4 (1988) 193): the point of
/// the difference a - b nearest to the origin, from simplices of its vertices, each nearer than the last.
/// It goes on until rounding stops it, not until some tolerance: the last simplex is then the pair of nearest
/// features, and normal and distance follow from it to rounding.  Where a plane is found on the way that has more than
/// `far` [m] between the two, it ends there: the distance is then an upper bound.  It begins with the farthest vertex of a
/// along `start`, and of b against it.
Nearest nearest(const Couple&, Real far, const Vector3& start);

}  // namespace cylon::engine
