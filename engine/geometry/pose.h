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

/// Where a part of a compound is.
inline Pose placed(const Pose& body, const ShapePart& part) {
  return {body.position + body.rotation * part.position, body.rotation * part.rotation};
}

/// visit(index, shape, pose) for each convex part of a shape: itself, or those of a compound.
template <class Visit>
void each_part(const Shape& shape, const Pose& pose, Visit&& visit) {
  const auto* compound = std::get_if<Compound>(&shape);
  if (compound == nullptr) return visit(0, shape, pose);
  for (std::size_t i = 0; i < compound->parts.size(); ++i)
    visit(static_cast<int>(i), compound->parts[i].shape, placed(pose, compound->parts[i]));
}

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

/// The point of a shape farthest along a direction, body axes [m]; the reference point of monostate.
Vector3 farthest(const Shape&, const Vector3& direction);

/// Whether a surface of the shape is curved, so that what it touches moves along it as it turns.
bool is_round(const Shape&);

/// The least axis-aligned box that holds the shape.  Empty (low = inf, high = -inf) for monostate.
Bounds bounds(const Shape&, const Pose&);

}  // namespace cylon::engine
