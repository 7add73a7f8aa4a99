#include "engine/contact/least_norm.h"

namespace cylon::engine {

LeastNorm::LeastNorm(const MatrixX& matrix) : decomposition_(matrix) {}

void LeastNorm::compute(const MatrixX& matrix, Real dependent) {
  decomposition_.setThreshold(dependent);
  decomposition_.compute(matrix);
}

VectorX LeastNorm::solve(const VectorX& y) const { return decomposition_.solve(y); }
Eigen::Index LeastNorm::rank() const { return decomposition_.rank(); }
MatrixX LeastNorm::inverse() const { return decomposition_.pseudoInverse(); }

}  // namespace cylon::engine
