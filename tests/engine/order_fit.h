// The order of a scheme from its errors over a fine ladder of steps.
#pragma once

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
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
/// Why this and no straight line: on smooth motion the error of a one-step scheme of order p at a fixed time
/// has the expansion  e(h) = e_p h^p + e_(p+k) h^(p+k) + ...  with k = 1, and k = 2 where the scheme is
/// reversible, as then only even powers follow (E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary
/// Differential Equations I, theorems II.8.1 and II.8.10).  So  log |e| = log |e_p| + p log h + a h^k +
/// O(h^2k): the third term is the leading one of what bends the line, and with it the larger steps, which are
/// further above rounding, tell the order too.  A scheme whose order is another does not get p back by a:
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

}  // namespace cylon
