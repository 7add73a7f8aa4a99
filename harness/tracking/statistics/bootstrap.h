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

/// The percentile interval (Efron 1979, Ann. Statist. 7, 1): the estimates of `draws` samples of the same size, drawn with
/// replacement, from their tail to their 1 - tail quantile.  Its level is `1 - 2 tail` as the sample grows.  Unbounded for
/// fewer than two values.  Deterministic by the seed.  0 < tail < 1/2, draws >= 2/tail.
Interval bootstrap(std::span<const double>, const std::function<double(std::span<const double>)>& estimate,
                   double tail, std::uint64_t seed, int draws = 4000);

}  // namespace cylon::statistics
