#include "harness/tracking/statistics/signed_rank.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace cylon::statistics {

// Without ties all doubled ranks are even, and half of the sums never occur.
SignedRankDistribution::SignedRankDistribution(const std::vector<int>& doubled_ranks)
    : unit_(std::all_of(doubled_ranks.begin(), doubled_ranks.end(), [](int r) { return r % 2 == 0; }) ? 2
                                                                                                      : 1),
      total_(std::accumulate(doubled_ranks.begin(), doubled_ranks.end(), 0)) {
  std::vector<double>& p = at_most_;
  p.assign(static_cast<std::size_t>(total_ / unit_) + 1, 0.0);
  p[0] = 1;
  std::size_t end = 1;  // sums so far are below
  for (const int rank : doubled_ranks) {
    const auto r = static_cast<std::size_t>(rank / unit_);
    end += r;
    for (std::size_t w = end; w-- > r;) p[w] = (p[w] + p[w - r]) / 2;
    for (std::size_t w = 0; w < std::min(r, end); ++w) p[w] /= 2;
  }
  std::partial_sum(p.begin(), p.end(), p.begin());
}

double SignedRankDistribution::at_most(int w) const {
  if (w < 0) return 0;
  return at_most_[std::min(static_cast<std::size_t>(w / unit_), at_most_.size() - 1)];
}

// b_i -> 1 - b_i takes W to sum(r) - W, and the small tail is summed from its small end.
double SignedRankDistribution::at_least(int w) const { return at_most(total_ - w); }

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
