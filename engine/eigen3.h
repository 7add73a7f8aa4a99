// Principal moments and axes of a symmetric 3 x 3 tensor, in plain arithmetic: the same bits from every
// compiler.
#pragma once

#include "engine/vector.h"

namespace cylon::engine {

/// What a symmetric tensor is in its own axes.  A = V diag(m) V^T.
struct Principal {
  Vector3 moments = Vector3::Zero();   ///< Ascending, in the unit of A.
  Matrix3 axes = Matrix3::Identity();  ///< Columns, in the order of the moments; orthonormal, determinant +1.
};

/// The principal moments and axes of A.  Any finite symmetric A, of any size; of A only the diagonal and what
/// lies above it are read.  Cyclic Jacobi rotations; G. H. Golub, C. F. Van Loan, Matrix Computations, 4th
/// ed., section 8.5.
///
/// The answer does not hang on the rounding with which A was put together:
/// - moments that differ by no more than 8 roundings are one moment, their mean;
/// - of equal moments the axes are those of A's own frame, turned as little as possible; all equal: the
/// frame's;
/// - a diagonal A gives a permutation of the frame's axes, the identity where it is in order;
/// - the greatest component of an axis is positive, except where the third must be turned round for a
///   right-handed frame.
Principal principal(const Matrix3& symmetric);

}  // namespace cylon::engine
