// Whether build B is slower than build A, from pairs of fresh processes run side by side: few pairs where the
// difference is plain, more where it is not, and "inconclusive" in place of a guess.
#pragma once

#include "harness/tracking/statistics/outcome.h"

#include <limits>
#include <span>
#include <vector>

namespace cylon::statistics {

/// How much is a difference, how sure a decision is, and when it may be taken.
struct PairedRule {
  struct Look {
    int pairs;
    double share;  ///< Of alpha.
  };

  double tau = 0.02;    ///< Ratios within 1/(1 + tau) … 1 + tau are the same.  > 0.
  double alpha = 0.01;  ///< Of each of the three decisions, over all looks.  In (0, 1/2).

  /// Bonferroni with weights: look k tests at alpha_k = share_k alpha, and the shares sum to 1.  An exact
  /// level needs only that the signs of the differences are fair coins under the hypothesis; boundaries that
  /// use how the looks depend on each other (Pocock, O'Brien-Fleming) would need differences of one
  /// distribution, which a loaded machine does not give.  The shares grow, because a difference near tau is
  /// found late; the first is just enough for ten of ten (2^-10 < 0.001), so that a plain slow-down costs ten
  /// pairs.
  std::vector<Look> looks = {{10, 0.10}, {16, 0.15}, {24, 0.20}, {32, 0.25}, {40, 0.30}};
};

struct PairedResult {
  Outcome outcome = Outcome::more;  ///< regressed, improved, same, more or inconclusive.
  int pairs = 0;                    ///< Of the look that decided, or the last taken; 0: none yet.
  int next = 0;                     ///< Pairs that the next look needs; 0: there is none.

  /// Valid in themselves and for Holm's adjustment across scenarios: the smallest over the looks taken of
  /// min(1, p_k / share_k), p_k exact.  <= alpha exactly where the outcome is regressed or improved.
  double p_regressed = 1, p_improved = 1;

  double estimate = std::numeric_limits<double>::quiet_NaN();  ///< Hodges-Lehmann, ln(B/A).
  Interval interval;                                           ///< Of the estimate, ln(B/A).
  double confidence = 0;                                       ///< Of the interval: 1 - 2 alpha_k.
};

/// Given d_i = ln(B_i / A_i) so far, in the order of measurement, what now?  At each look n = 10, 16, 24, 32,
/// 40,
///     regressed     the exact signed-rank test refuses "centre <= +ln(1 + tau)" at alpha_k,
///     improved      it refuses "centre >= -ln(1 + tau)" at alpha_k,
///     same          the Hodges-Lehmann interval of confidence 1 - 2 alpha_k lies inside +-ln(1 + tau);
/// the first look that decides is the answer, and pairs after it are not looked at: to give one pair more
/// never changes a decision.  Otherwise `more`, and `inconclusive` after the last look.  Where A and B are
/// one program the pairs are exchangeable, so d is symmetric about 0 whatever the noise; where B is slower by
/// a factor, about its logarithm.  Throws std::invalid_argument on a value that is not finite.
///
/// To judge m scenarios together, sample each with alpha / m (Holm's first step: nothing stops too early to
/// be confirmed), then hold the adjusted p against alpha.
PairedResult decide(std::span<const double> log_ratios, const PairedRule& = {});

}  // namespace cylon::statistics
