// On which side of a plane through three points a fourth is: the exact sign.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace cylon::engine {

/// The sign of det(b - a, c - a, d - a): > 0 where d is on the side to which the normal (b - a) x (c - a)
/// points, 0 exactly where the four are in a plane.  A filter in double, then expansions: J. R. Shewchuk,
/// Adaptive Precision Floating-Point Arithmetic, Discrete & Computational Geometry 18 (1997) 305.
/// Requires coordinates far from overflow and underflow.
int side_of_plane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                  const Eigen::Vector3d& d);

}  // namespace cylon::engine
