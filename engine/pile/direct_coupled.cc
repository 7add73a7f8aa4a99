// Newton's method for exact Coulomb friction: the friction limits depend on the unknown normal impulses.
#include "engine/pile/direct.h"

#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace cylon::engine::pile {
namespace {

constexpr int most_steps = 12;

Eigen::Matrix<double, 3, 6> jacobian(const Eigen::Vector3d& arm, bool align) {
  Eigen::Matrix<double, 3, 6> j;
  if (align)
    j << Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Identity();
  else
    j << Eigen::Matrix3d::Identity(),
        Eigen::Matrix3d{{0, arm.z(), -arm.y()}, {-arm.z(), 0, arm.x()}, {arm.y(), -arm.x(), 0}};
  return j;
}

}  // namespace

// G(V) = M (V - c) - J^T f(y) = 0 with f_t = friction y_n y_t/|y_t| where it slips.  Its derivative is not
// symmetric and may have directions that pull the other way (rows of bodies that slide on two faces share
// their loads so): a root that the rounds run away from is a root all the same.
bool Direct::couple() {
  start_ = v_;
  for (Row& row : rows_) row.start_limit = row.limit;
  double before = std::numeric_limits<double>::infinity();
  const auto size = v_.size();
  for (int step = 0; step < most_steps; ++step) {
    forces(v_, true, true);
    fill_gradient();
    dense_.setZero(size, size);
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(6 * k);
      dense_.block<6, 6>(at, at) = masses_[k];
    }
    for (const Row& row : rows_) {
      const bool align = row.block->angular;
      const Eigen::Matrix<double, 3, 6> a = jacobian(row.arm, align), b = -jacobian(row.to_arm, align);
      const auto add = [&](int to, const auto& j, int by, const auto& other) {
        if (to >= 0 && by >= 0) dense_.block<6, 6>(to, by) += j.transpose() * row.slope * other;
      };
      add(row.a, a, row.a, a), add(row.a, a, row.b, b), add(row.b, b, row.a, a), add(row.b, b, row.b, b);
    }
    gradient_ = dense_.partialPivLu().solve(gradient_);
    const double change = gradient_.cwiseAbs().maxCoeff();
    if (!(change < before) && !(change <= rounding_)) break;
    before = change;
    v_ -= gradient_;
    if (change <= std::max(1e-10 * v_.cwiseAbs().maxCoeff(), rounding_)) {
      forces(v_, false, true);
      return true;
    }
  }
  v_ = start_;
  for (Row& row : rows_) row.limit = row.start_limit;
  return false;
}

}  // namespace cylon::engine::pile
