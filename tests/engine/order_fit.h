// The order of an integrator from its errors over a fine ladder of steps.
#pragma once

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace cylon {

/// Numbers of steps from `first` to at most `last`, each some 15 % more than the one before.
inline std::vector<int> fine_ladder(int first, int last) {
  constexpr double ratio = 1.15;
  std::vector<int> counts;
  for (double n = first; n <= last; n = std::max(n * ratio, std::floor(n) + 1))
    counts.push_back(static_cast<int>(n));
  return counts;
}

/// p of  log error = c + p log h + a h^k,  least squares.
///
/// Why this and no straight line: on smooth motion the error of a one-step integrator of order p at a fixed
/// time has the expansion  e(h) = e_p h^p + e_(p+k) h^(p+k) + ...  with k = 1, and k = 2 where the
/// integrator is reversible, as then only even powers follow (E. Hairer, S. P. Norsett, G. Wanner, Solving
/// Ordinary Differential Equations I, theorems II.8.1 and II.8.10).  So  log |e| = log |e_p| + p log h + a
/// h^k + O(h^2k): the third term is the leading one of what bends the line, and with it the larger steps,
/// which are further above rounding, tell the order too.  An integrator whose order is another does not get
/// p back by a:
/// over the ladder log h goes on to fall where h^k vanishes.
inline double fitted_order(const std::vector<double>& step, const std::vector<double>& error,
                           bool reversible) {
  const auto n = static_cast<Eigen::Index>(step.size());
  Eigen::MatrixXd terms(n, 3);
  Eigen::VectorXd logs(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double h = step[static_cast<std::size_t>(i)] / step[0];
    terms.row(i) << 1, std::log(h), reversible ? h * h : h;
    logs[i] = std::log(error[static_cast<std::size_t>(i)]);
  }
  return terms.colPivHouseholderQr().solve(logs)[1];
}

/// The part of a ladder that a fit in double takes: four decades, from a hundred times what rounding leaves
/// on, so that rounding is a hundredth of the smallest error.
struct Convergence {
  static constexpr double clear = 100, decades = 1e4;
  static constexpr double coarse = 1e-2;  ///< An error above this part of the motion is not small against it.
  /// Fewer steps than these, and the step is long against the motion while the error is near rounding
  /// already: there is no order to be seen in double.
  static constexpr std::size_t fewest = 6;

  std::vector<double> step, error;
  double floor = 0;    ///< What rounding leaves.
  bool exact = false;  ///< At the floor with the largest step already.

  bool tells() const { return step.size() >= fewest; }
};

/// Errors (relative to the motion's size, smooth in the step: a root mean square, no maximum) of `counts`
/// steps over `span`, downward until they fall no more.  `least`: what rounding leaves at the least.
template <class ErrorOf>
Convergence converge(const std::vector<int>& counts, double span, double least, ErrorOf error_of) {
  Convergence all, fitted;
  double best = std::numeric_limits<double>::infinity();
  all.floor = least;
  for (const int n : counts) {
    const double error = error_of(n);
    if (all.step.empty() && error <= 1e3 * least) {
      fitted.exact = true;
      return fitted;
    }
    if (!std::isfinite(error)) continue;
    all.step.push_back(span / n), all.error.push_back(error);
    best = std::min(best, error);
    if (best < 1e-6 && error > 3 * best) {
      all.floor = best;
      break;
    }
  }
  fitted.floor = all.floor;
  const double from = std::max(best, Convergence::clear * all.floor);
  const double to = std::min(Convergence::coarse, Convergence::decades * from);
  for (std::size_t i = 0; i < all.step.size(); ++i) {
    if (all.error[i] < from || all.error[i] > to) continue;
    fitted.step.push_back(all.step[i]), fitted.error.push_back(all.error[i]);
  }
  return fitted;
}

}  // namespace cylon
