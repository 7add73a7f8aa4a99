// The engine's number type and its vectors.  Everything is SI, right-handed; world axes unless said
// otherwise.  The same sources are built twice: with CYLON_ENGINE_FLOAT the number type is float.  With
// CYLON_ENGINE_LONG, for the headers of integrators/ alone, it has 64 bits: orders are seen far above
// rounding.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <limits>
#include <numbers>

namespace cylon::engine {

#ifdef CYLON_ENGINE_LONG
using Real = long double;
using Time = long double;
#else
#ifdef CYLON_ENGINE_FLOAT
using Real = float;
#else
using Real = double;
#endif
using Time = double;  ///< Instants and steps [s], in both builds: t_n = n dt would lose its digits in float.
#endif

using Vector3 = Eigen::Matrix<Real, 3, 1>;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;
using Quaternion = Eigen::Quaternion<Real, Eigen::DontAlign>;  ///< Packs into a Motion without gaps.

/// Index of the world where a body is asked for: the other end of a spring, a joint or a contact.
inline constexpr int fixed_world = -1;

/// The distance of 1 to the next Real: a rounded result is off by half of it, relative, at most.
inline constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

inline constexpr Real pi = std::numbers::pi_v<Real>;

/// Whether a Real has the digits of double, for bounds that were measured in each of the two.
inline constexpr bool is_double = sizeof(Real) == 8;

/// The matrix of  x -> r x x.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 3> cross_matrix(const Eigen::Matrix<Scalar, 3, 1>& r) {
  Eigen::Matrix<Scalar, 3, 3> m;
  m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m;
}

/// The number of a body or a row, as containers want it.
constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace cylon::engine
