// Newton's method for exact Coulomb friction: the friction limits depend on the unknown normal impulses.
#include "engine/operations.h"
#include "engine/pile/direct.h"

#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace cylon::engine::pile {
namespace {

constexpr int most_steps = 12;
constexpr std::size_t most_skewed = 1024;  // rows that slip: their cube is part of the work of a step

}  // namespace

// Z = S^-1 U and (1 + W^T Z)^-1 of the matrix S + U W^T, where S is the symmetric part and each row that slips has a column of
// U = J^T skewed and W = J^T n.  M. A. Woodbury, Inverting modified matrices, Princeton (1950).
bool Direct::factor_skewed() {
  factor();
  skew_rows_.clear();
  for (const Row& row : rows_)
    if (!row.skewed.isZero(0)) skew_rows_.push_back(&row);
  if (skew_rows_.size() > most_skewed || operations_ > last_) return false;
  const auto count = static_cast<Eigen::Index>(skew_rows_.size());
  along_.resize(v_.size(), count), unskewed_.resize(v_.size(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Row& row = *skew_rows_[static_cast<std::size_t>(k)];
    column_.setZero(v_.size());
    add_impulse(row, row.n, column_);
    along_.col(k) = column_;
    column_.setZero();
    add_impulse(row, row.skewed, column_);
    matrix_.solve(column_);
    unskewed_.col(k) = column_;
  }
  if (count == 0) return true;
  few_ = along_.transpose() * unskewed_;
  few_.diagonal().array() += 1;
  few_factored_.compute(few_);
  const auto rows = static_cast<std::int64_t>(count);
  operations_ += row_operations(rows * (matrix_.solve_work() + rows * v_.size()));
  return true;
}

// x <- S^-1 x,  x <- x - Z (1 + W^T Z)^-1 W^T x
void Direct::solve_skewed(Vector& x) {
  matrix_.solve(x);
  if (skew_rows_.empty()) return;
  few_rates_ = few_factored_.solve(along_.transpose() * x);
  x.noalias() -= unskewed_ * few_rates_;
}

// to <- to - (S + U W^T) x
void Direct::subtract_product(const Vector& x, Vector& to) {
  for (const Row& row : rows_) {
    const V3 u = velocity(row, x) - row.bias;
    add_impulse(row, -(row.slope * u + row.n.dot(u) * row.skewed), to);
  }
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(6 * k);
    to.segment<6>(at) -= masses_[k] * x.segment<6>(at);
  }
}

// Of the velocities at the rows' places.
double Direct::farthest(const Vector& x, const Vector& y) const {
  double result = 0;
  for (const Row& row : rows_)
    if (!row.block->angular) result = std::max(result, (velocity(row, x) - velocity(row, y)).norm());
  return result;
}

// G(V) = M (V - c) - J^T f(y) = 0 with f_t = friction y_n y_t/|y_t| where it slips.  Its derivative is not
// symmetric and may have directions that pull the other way (rows of bodies that slide on two faces share
// their loads so): a root that the rounds run away from is a root all the same, up to `reach` [m/s] from there.
bool Direct::couple(double reach) {
  start_ = v_;
  for (Row& row : rows_) row.start_limit = row.limit;
  double before = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_steps; ++step) {
    forces(v_, true, true);
    fill_gradient();
    if (!factor_skewed()) break;
    way_ = gradient_;
    solve_skewed(way_);
    // Stiff rows beside soft ones cost digits, which the rest gives back.
    if (!skew_rows_.empty()) {
      subtract_product(way_, gradient_);
      solve_skewed(gradient_);
      way_ += gradient_;
    }
    const double change = way_.cwiseAbs().maxCoeff();
    if (!(change < before) && !(change <= rounding_)) break;
    before = change;
    v_ -= way_;
    if (change <= std::max(1e-10 * v_.cwiseAbs().maxCoeff(), rounding_)) {
      if (farthest(v_, start_) > reach) break;
      forces(v_, false, true);
      return true;
    }
  }
  v_ = start_;
  for (Row& row : rows_) row.limit = row.start_limit;
  return false;
}

}  // namespace cylon::engine::pile
