// How often something happens, and whether one of two happens more often than the other.
#pragma once

#include "harness/tracking/statistics/outcome.h"

#include <cstddef>
#include <span>

namespace cylon::statistics {

/// The share that `hits` of `trials` tell of, with probability of at least 1 - 2 tail (Clopper and Pearson 1934, Biometrika
/// 26, 404): low solves P(X >= hits) = tail, high P(X <= hits) = tail.  [0, 1] for no trials.  0 < tail < 1/2; throws
/// std::invalid_argument for hits > trials.
Interval proportion_interval(std::size_t hits, std::size_t trials, double tail);

/// The mean of shares of clusters, each in [0, 1], whose members hang together: Clopper and Pearson's interval for as many
/// trials as there are clusters and the sum of the shares as hits.  Of all distributions in [0, 1] with one mean, a coin's
/// spreads most, so that shares between are held at least as often.  An interval from their own spread (a bootstrap, an effective
/// number of trials) misses the mean whenever a sample happens to have none of the few low ones.  [0, 1] for none.
Interval share_interval(std::span<const double> shares, double tail);

/// p of "either is as likely" where of `one` + `other` independent pairs that differ, `one` went one way (the exact sign
/// test, both sides): min(1, 2 P(X <= min(one, other))), X binomial with 1/2.  1 for no pairs.
double sign_test(std::size_t one, std::size_t other);

}  // namespace cylon::statistics
