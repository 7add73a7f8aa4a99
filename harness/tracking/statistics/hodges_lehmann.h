// The centre of a symmetric distribution and an interval for it, both from the signed-rank test: half of the
// sample may be outliers of one side before the estimate leaves (29 % of it, to be exact).
#pragma once

#include "harness/tracking/statistics/outcome.h"

#include <span>

namespace cylon::statistics {

/// The median of the Walsh averages (x_i + x_j)/2, i <= j (Hodges and Lehmann 1963, Ann. Math. Stat. 34,
/// 598). NaN where there is no value.
double hodges_lehmann(std::span<const double>);

/// The shifts that the exact signed-rank test does not refuse at level `tail` on either side: from the k-th
/// to the k-th last Walsh average, with k the largest that has P(W <= k - 1) <= tail.  Covers the centre with
/// probability >= 1 - 2 tail whatever the symmetric distribution; unbounded where n is so small that no shift
/// can be refused (2^-n > tail).  0 < tail < 1/2.
Interval hodges_lehmann_interval(std::span<const double>, double tail);

}  // namespace cylon::statistics
