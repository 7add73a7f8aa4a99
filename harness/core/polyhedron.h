// Volume, centre and second moments of a closed triangle mesh, exactly; and the convex hull of points.
#pragma once

#include "harness/core/scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace cylon::core {

using Triangle = std::array<std::int32_t, 3>;

/// A solid of density 1.
struct Solid {
  double volume = 0;                  ///< [m^3]
  Vector3 centre = Vector3::Zero();   ///< [m]
  Matrix3 inertia = Matrix3::Zero();  ///< About the centre [m^5].
};

/// Integrals over the inside of a closed mesh with outward (counter-clockwise) faces.
/// Throws std::invalid_argument, saying what is wrong: an index out of range, an edge that is not shared by
/// exactly two faces of the same sense (open or inconsistent), or a volume that is not positive (inside out).
Solid solid(const std::vector<Vector3>& vertices, const std::vector<Triangle>& faces);

/// Outward triangles of the convex hull.  Throws std::invalid_argument where the points span no volume.
std::vector<Triangle> convex_hull(const std::vector<Vector3>& points);

}  // namespace cylon::core
