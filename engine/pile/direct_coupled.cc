// Newton's method for exact Coulomb friction: the friction limits depend on the unknown normal impulses.
#include "engine/operations.h"
#include "engine/pile/direct.h"

#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace cylon::engine::pile {
namespace {

constexpr int most_steps = 12;
constexpr Eigen::Index most_dense = 4096;  // unknowns: their cube is the work of a step

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
    if (std::none_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.skew; })) {
      factor();
      matrix_.solve(gradient_);
    } else {
      if (size > most_dense || operations_ > last_) break;
      dense_.setZero(size, size);
      const auto add_part = [&](int at, int other, const M6& sum) { dense_.block<6, 6>(at, other) += sum; };
      for (std::size_t k = 0; k < bodies_.size(); ++k)
        add_part(6 * static_cast<int>(k), 6 * static_cast<int>(k), masses_[k]);
      add_slopes(add_part);
      gradient_ = dense_.partialPivLu().solve(gradient_);
      operations_ += row_operations(size * size * size / 3);
    }
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
