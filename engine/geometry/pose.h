// Where a shape is, and how far it reaches.
#pragma once

#include "engine/body.h"
#include "engine/shape.h"

#include <optional>

namespace cylon::engine {

/// Body to world: x = position + rotation x_body.
struct Pose {
  Vector3 position = Vector3::Zero();      ///< Of the body's reference point [m].
  Matrix3 rotation = Matrix3::Identity();  ///< Orthonormal to rounding.
};

inline Pose pose(const Motion& motion) { return {motion.position, motion.orientation.toRotationMatrix()}; }

/// An axis-aligned box, world axes [m].  Empty where low > high.
struct Bounds {
  Vector3 low, high;
};

/// The radius of the ball about the reference point that holds the shape [m].  0 for monostate.
Real bounding_radius(const Shape&);

/// The least half-width of a shape [m], 0 where there is none: what a body may not jump over.
Real half_width(const Shape&);

/// All points within `radius` of a box about the reference point, body axes [m]; the box may be a segment
/// or a point.
struct RoundedBox {
  Vector3 half_extents;
  Real radius;
};
/// The shape as one; nothing where it is none.
std::optional<RoundedBox> rounded_box(const Shape&);

/// The least axis-aligned box that holds the shape.  Empty (low = inf, high = -inf) for monostate.
Bounds bounds(const Shape&, const Pose&);

}  // namespace cylon::engine
