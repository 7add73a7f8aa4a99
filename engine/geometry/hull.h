// Makes convex polyhedra, and tells whether a mesh is one.
#pragma once

#include "engine/shape.h"

#include <array>
#include <vector>

namespace cylon::engine {

/// The convex hull of points [m].  Coplanar triangles are merged to polygons, corners between them dropped;
/// vertices keep the order of the input, so the same points give the same hull on every machine.  Throws
/// std::invalid_argument that says why: fewer than 4 points, a coordinate that is no finite number, all
/// points in a plane.  Flat means: within 64 eps times the size.
Hull make_hull(const std::vector<Vector3>& points);

/// A triangle as a hull without thickness, with a face on either side.  Requires corners that are not in a line.
Hull make_triangle(const std::array<Vector3, 3>& corners);

/// Whether a closed triangle mesh is convex, so that its hull is the mesh: every edge has two triangles, of
/// opposite sense, and no vertex lies outside the plane of any triangle.  That the centre of mass is inside
/// is not enough (seed section 12; errata 37).
bool is_convex(const std::vector<Vector3>& vertices, const std::vector<std::array<int, 3>>& triangles);

}  // namespace cylon::engine
