// Linear equations that may be redundant or contradict each other.  In a source of its own, as Eigen's
// templates for it take the compiler five seconds in each source that uses them.
#pragma once

#include "engine/vector.h"

#include <Eigen/QR>

namespace cylon::engine {

using MatrixX = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using VectorX = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

/// Of all x for which |M x - y| is least, the one of least norm: x = M^+ y.
class LeastNorm {
 public:
  LeastNorm() = default;
  explicit LeastNorm(const MatrixX& matrix);
  /// A pivot below `dependent` times the largest counts as zero.
  LeastNorm(const MatrixX& matrix, Real dependent) { compute(matrix, dependent); }
  /// Another matrix in the same storage.
  void compute(const MatrixX& matrix, Real dependent);

  VectorX solve(const VectorX& y) const;
  MatrixX inverse() const;  ///< M^+
  Eigen::Index rank() const;

 private:
  Eigen::CompleteOrthogonalDecomposition<MatrixX> decomposition_;
};

}  // namespace cylon::engine
