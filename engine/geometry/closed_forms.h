// The signed distances that have a formula.
#pragma once

#include "engine/geometry/separation.h"

namespace cylon::engine {

/// As separation(); the shapes are what the name says, in its order.
Separation sphere_sphere(const Shape&, const Pose&, const Shape&, const Pose&);
Separation sphere_box(const Shape&, const Pose&, const Shape&, const Pose&);
Separation sphere_capsule(const Shape&, const Pose&, const Shape&, const Pose&);
Separation capsule_capsule(const Shape&, const Pose&, const Shape&, const Pose&);

/// Of balls about two points `a` and `b`, world axes; `across` [any length > 0] is the normal where they
/// coincide to rounding of `size` [m].
Separation between_points(const Vector3& a, Real radius_a, const Vector3& b, Real radius_b,
                          const Vector3& across, Real size);

}  // namespace cylon::engine
