#include "harness/tracking/statistics/proportion.h"

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>

#include <algorithm>
#include <stdexcept>

namespace cylon::statistics {
namespace {

// P(X >= k) for n trials of share p is the regularised incomplete beta function I_p(k, n - k + 1), so that the bounds are
// quantiles of beta distributions; k and n need not be whole.
Interval of_beta(double k, double n, double tail) {
  if (!(tail > 0 && tail < 0.5)) throw std::invalid_argument("a tail is in (0, 1/2)");
  using boost::math::beta_distribution;
  Interval found{0, 1};
  if (k > 0) found.low = quantile(beta_distribution<double>(k, n - k + 1), tail);
  if (k < n) found.high = quantile(complement(beta_distribution<double>(k + 1, n - k), tail));
  return found;
}

}  // namespace

Interval proportion_interval(std::size_t hits, std::size_t trials, double tail) {
  if (hits > trials) throw std::invalid_argument("more hits than trials");
  return of_beta(static_cast<double>(hits), static_cast<double>(trials), tail);
}

Interval share_interval(std::span<const double> shares, double tail) {
  double sum = 0;
  for (const double share : shares) {
    if (!(share >= 0 && share <= 1)) throw std::invalid_argument("a share is outside [0, 1]");
    sum += share;
  }
  const auto n = static_cast<double>(shares.size());
  return of_beta(std::min(sum, n), n, tail);
}

double sign_test(std::size_t one, std::size_t other) {
  const std::size_t n = one + other;
  if (n == 0) return 1;
  const boost::math::binomial_distribution<double> fair(static_cast<double>(n), 0.5);
  return std::min(1.0, 2 * cdf(fair, static_cast<double>(std::min(one, other))));
}

}  // namespace cylon::statistics
