// What follows from a shape alone: extent, and centre of mass and inertia of a solid of uniform density.  A
// shape that misses one of them does not compile.
#pragma once

#include "harness/core/scene.h"

#include <optional>

namespace cylon::core {

struct MassProperties {
  double mass = 0;                    ///< [kg]
  Vector3 centre = Vector3::Zero();   ///< In the shape's own coordinates [m].
  Matrix3 inertia = Matrix3::Zero();  ///< About the centre, the shape's axes [kg m^2].
};

/// Of a solid of the given mass [kg] and uniform density; a point has mass x 1 m^2 about every axis, because
/// it has no orientation and any positive inertia serves.  A compound's parts carry their own masses. Throws
/// std::invalid_argument for a mesh that is not closed or a hull without volume.
MassProperties mass_properties(const Shape&, double mass);

/// The shape moved by `offset` in its own coordinates: hulls, meshes and compounds; others stay where they
/// are.
void move(Shape&, const Vector3& offset);

/// Distance from the origin of the farthest point [m]; 0 without a shape.
double bounding_radius(const Shape&);

/// max over the shape of d . x, with d a unit vector in the shape's own axes [m]; 0 without a shape.
double support(const Shape&, const Vector3& d);

/// Why these are no moments of inertia, or nothing when they are: each >= 0 (> 0 for two at least), and none
/// larger than the sum of the others beyond rounding.
std::optional<std::string> impossible(const Matrix3& inertia);

}  // namespace cylon::core
