// Intervals of an estimate by drawing the sample anew from itself.
#pragma once

#include "harness/tracking/statistics/outcome.h"

#include <cstdint>
#include <functional>
#include <span>

namespace cylon::statistics {

/// The middle value, or the mean of the two in the middle; NaN where there is none.
double median(std::span<const double>);

double mean(std::span<const double>);  ///< NaN where there is no value.

/// The expanded percentile interval (Hesterberg 2015, Am. Statist. 69, 371, section 5.3): the estimates of `draws` samples of the same
/// size, drawn with replacement, from their a to their 1 - a quantile, a = Phi(-sqrt(n/(n - 1)) t), t the 1 - tail quantile of
/// Student's t with n - 1 degrees of freedom.  With a = tail (Efron 1979) it would be too narrow for few values: of ten, 95 % would
/// hold the mean in 90 %.  Its level is `1 - 2 tail` as the sample grows.  Unbounded where 2^-n > tail: all n values lie above the
/// median as often.  Deterministic by the seed.  0 < tail < 1/2, draws >= 2/tail.
Interval bootstrap(std::span<const double>, const std::function<double(std::span<const double>)>& estimate,
                   double tail, std::uint64_t seed, int draws = 4000);

}  // namespace cylon::statistics
