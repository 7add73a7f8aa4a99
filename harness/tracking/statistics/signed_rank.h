// Wilcoxon's signed-rank test with its exact null distribution: no normal approximation at any size, so that
// a decision at ten pairs is worth what it says.
#pragma once

#include <span>
#include <vector>

namespace cylon::statistics {

/// The distribution of W = sum of r_i b_i, with b_i independent fair bits: the sum of the ranks of the
/// positive differences when each difference is as likely to be positive as negative.  Ranks are doubled, so
/// that the mid-ranks of ties are whole numbers.  Built by dynamic programming over the ranks,
///     P_i(w) = (P_{i-1}(w) + P_{i-1}(w - r_i)) / 2,
/// in sum(r) len(r) operations.  Every probability is a multiple of 2^-n: exact in a double up to n = 53
/// ranks, and of a relative error below n 2^-53 beyond.
class SignedRankDistribution {
 public:
  explicit SignedRankDistribution(const std::vector<int>& doubled_ranks);

  /// P(W <= w) and P(W >= w), with w doubled too; any w.
  double at_most(int w) const;
  double at_least(int w) const;

 private:
  int unit_, total_;             // sums are multiples of the one, and end with the other
  std::vector<double> at_most_;  // by sum / unit
};

/// The ranks of |d_i - shift| among all i, doubled, and the sum of those with d_i > shift.
struct SignedRanks {
  std::vector<int> doubled;  ///< Of the differences that are not zero.
  int positive = 0;
};

/// Ties share their mean rank.  Zeros are ranked with the others and then left out (Pratt 1959, J. Am. Stat.
/// Assoc. 54, 655): to leave them out before ranking, as Wilcoxon did, lets a test become *more* certain when
/// evidence against it is moved to zero.  Throws std::invalid_argument on a value that is not finite.
SignedRanks signed_ranks(std::span<const double> differences, double shift);

/// The one-sided p values of the hypotheses that the differences are symmetric about a centre <= shift
/// (against: above it) and about a centre >= shift (against: below it).  1 where no difference is left.
double p_above(std::span<const double> differences, double shift);
double p_below(std::span<const double> differences, double shift);

}  // namespace cylon::statistics
