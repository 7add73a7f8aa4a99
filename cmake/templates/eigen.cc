#include "cmake/templates/eigen.h"

template class Eigen::JacobiSVD<Eigen::Matrix<double, 2, 3>, Eigen::ColPivHouseholderQRPreconditioner>;
