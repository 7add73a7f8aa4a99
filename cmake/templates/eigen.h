// What sources would compile each for itself: Quaternion::FromTwoVectors falls back to a singular value decomposition,
// which takes 10 s of the compiler.  templates/eigen.cc compiles it for all of them.  For precompiled headers alone; no source
// includes it.
#pragma once

#include <Eigen/SVD>

extern template class Eigen::JacobiSVD<Eigen::Matrix<double, 2, 3>, Eigen::ColPivHouseholderQRPreconditioner>;
