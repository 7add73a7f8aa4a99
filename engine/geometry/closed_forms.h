// The pairs of shapes that have a form of their own; all others take the general algorithms.
#pragma once

#include "engine/geometry/manifold.h"

namespace cylon::engine {

/// As separation().
Separation closed_form(const Sphere&, const Pose&, const Sphere&, const Pose&);
Separation closed_form(const Sphere&, const Pose&, const Box&, const Pose&);
Separation closed_form(const Sphere&, const Pose&, const Capsule&, const Pose&);
Separation closed_form(const Sphere&, const Pose&, const Frustum&, const Pose&);
Separation closed_form(const Capsule&, const Pose&, const Capsule&, const Pose&);

/// As manifold(): two points where they lie side by side.
Manifold closed_manifold(const Capsule&, const Pose&, const Capsule&, const Pose&, Real margin);

/// Of balls about two points `a` and `b`, world axes; `across` [any length > 0] is the normal where they
/// coincide to rounding of `size` [m].
Separation between_points(const Vector3& a, Real radius_a, const Vector3& b, Real radius_b,
                          const Vector3& across, Real size);

}  // namespace cylon::engine
