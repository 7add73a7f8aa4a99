// How far two convex shapes are apart, or how deep they are in one another: one signed distance for every
// pair of shapes.
#pragma once

#include "engine/geometry/pose.h"

namespace cylon::engine {

/// Signed distance: > 0 apart, the least distance between points of the two; < 0 overlapping, minus the
/// least translation that separates them (so at contact it goes through zero without a kink along a fixed
/// normal).  d(gap)/dt = normal . (v_body at point - v_other at other_point), where the normal is unique.
struct Separation {
  Real gap = 0;         ///< [m]; infinite where one of the two has no shape.
  Vector3 normal;       ///< Unit, world axes, from `other` to `body`.
  Vector3 point;        ///< Of `body`, world axes [m].
  Vector3 other_point;  ///< Of `other`; point - other_point = gap normal, to rounding.
};

/// Exact to rounding: a few eps times the size of the pair (the two shapes and the way between them).
/// Replaces seed eq. 98-103, which know vertices against triangles only (errata 34-36).  Requires hulls of
/// make_hull.  No allocation.
Separation separation(const Shape& body, const Pose&, const Shape& other, const Pose& other_pose);
Separation separation(const Shape& body, const Pose&, const Plane& other);

}  // namespace cylon::engine
