// The gap between two convex bodies and where it is, from support points alone: outside each other the distance
// (Gilbert, Johnson, Keerthi 1988), inside the depth, the least way out (expanding polytope, van den Bergen
// 2001).  Knows shapes, no scene; shares no code with any engine.
#pragma once

#include "harness/core/shapes.h"

#include <optional>
#include <vector>

namespace cylon::core {

/// A convex shape at its place in the world.
struct Placed {
  const Primitive* shape = nullptr;
  Vector3 position = Vector3::Zero();
  Quaternion orientation = Quaternion::Identity();
};

/// Where two bodies are nearest to each other or, of overlapping ones, deepest in each other.
struct Nearest {
  double gap = 0;                       ///< [m]; minus the depth inside.
  Vector3 normal = Vector3::UnitY();    ///< Unit, from the first to the second.
  Vector3 on_first = Vector3::Zero();   ///< World [m].
  Vector3 on_second = Vector3::Zero();  ///< on_first + gap normal.
};

/// Of two convex shapes.  The gap is right to 1e-10 of the larger body's size for polyhedra, spheres, capsules
/// and rods; for cylinders, cones and discs inside others to 1e-6.
Nearest nearest(const Placed&, const Placed&);

/// The convex parts of a shape in body axes, of a mesh its triangles, whose inside is empty; nothing without a shape.
std::vector<Part> convex_parts(const Shape&);

/// A point of a convex shape, or of a compound, that lies farthest along d, in the shape's own axes; of equally
/// far ones the first.
Vector3 farthest_point(const Shape&, const Vector3& d);

}  // namespace cylon::core
