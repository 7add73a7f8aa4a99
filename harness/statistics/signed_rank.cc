#include "harness/statistics/signed_rank.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace cylon::statistics {

SignedRankDistribution::SignedRankDistribution(const std::vector<int>& doubled_ranks) : at_most_{1.0} {
  std::vector<double>& p = at_most_;
  for (const int rank : doubled_ranks) {
    const auto r = static_cast<std::size_t>(rank);
    p.resize(p.size() + r, 0.0);
    for (std::size_t w = p.size(); w-- > 0;) p[w] = (p[w] + (w >= r ? p[w - r] : 0.0)) / 2;
  }
  std::partial_sum(p.begin(), p.end(), p.begin());
}

double SignedRankDistribution::at_most(int w) const {
  if (w < 0) return 0;
  return at_most_[std::min(static_cast<std::size_t>(w), at_most_.size() - 1)];
}

// b_i -> 1 - b_i takes W to sum(r) - W, and the small tail is summed from its small end.
double SignedRankDistribution::at_least(int w) const {
  return at_most(static_cast<int>(at_most_.size()) - 1 - w);
}

SignedRanks signed_ranks(std::span<const double> differences, double shift) {
  std::vector<double> left(differences.begin(), differences.end());
  for (double& d : left) {
    d -= shift;
    if (!std::isfinite(d)) throw std::invalid_argument("a difference is not finite");
  }
  std::sort(left.begin(), left.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  SignedRanks ranks;
  for (std::size_t i = 0, end = 0; i < left.size(); i = end) {
    while (end < left.size() && std::abs(left[end]) == std::abs(left[i])) ++end;
    const auto doubled = static_cast<int>(i + 1 + end);  // twice the mean of the ranks i + 1 … end
    for (std::size_t k = i; k < end && left[k] != 0; ++k) {
      ranks.doubled.push_back(doubled);
      if (left[k] > 0) ranks.positive += doubled;
    }
  }
  return ranks;
}

double p_above(std::span<const double> differences, double shift) {
  const SignedRanks ranks = signed_ranks(differences, shift);
  return SignedRankDistribution(ranks.doubled).at_least(ranks.positive);
}

double p_below(std::span<const double> differences, double shift) {
  const SignedRanks ranks = signed_ranks(differences, shift);
  return SignedRankDistribution(ranks.doubled).at_most(ranks.positive);
}

}  // namespace cylon::statistics
