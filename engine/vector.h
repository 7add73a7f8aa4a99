// The engine's number type and its vectors.  Everything is SI, right-handed; world axes unless said
// otherwise.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace cylon::engine {

using Real = double;
using Vector3 = Eigen::Matrix<Real, 3, 1>;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;
using Quaternion = Eigen::Quaternion<Real>;

/// Index of the world where a body is asked for: the other end of a spring, a joint or a contact.
inline constexpr int fixed_world = -1;

}  // namespace cylon::engine
