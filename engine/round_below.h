// The part of a body of revolution below a horizontal plane: cylinders, cones, capsules.
#pragma once

#include "engine/shape.h"

namespace cylon::engine {

struct RoundBelow {
  Real volume = 0;  ///< [m^3]
  Vector3 moment =
      Vector3::Zero();  ///< Volume times centroid, from the origin of the shape, world axes [m^4].
};

/// The part with y <= height, seen from the origin of the shape [m], of a shape whose axis is `axis` (unit, world axes):
/// to rounding of the whole, by quadrature.
RoundBelow round_below(const Frustum&, const Vector3& axis, Real height);
RoundBelow round_below(const Capsule&, const Vector3& axis, Real height);

/// Of all of it [m^3].
Real whole_volume(const Frustum&);
Real whole_volume(const Capsule&);

}  // namespace cylon::engine
