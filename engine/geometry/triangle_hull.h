// The convex hull of points in general position, as triangles: the topology that make_hull refines.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace cylon::engine {

/// Triangles counter-clockwise from outside.  Points are added one by one: those triangles that see a point
/// are replaced by a fan from it to their border.  All decisions by exact signs, so the result is a closed
/// surface whatever the points.  `first`: four points that are not in a plane.  O(points x triangles).
std::vector<std::array<int, 3>> triangle_hull(const std::vector<Eigen::Vector3d>& points,
                                              const std::array<int, 4>& first);

}  // namespace cylon::engine
