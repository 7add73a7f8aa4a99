// How far a run is from a measured motion, with the interval that holds it at 95 %.
//
// At a measured time, with Q the observable of a body or joint, y what was measured, x the measured start and f the engine:
//     r = Q(f(x)) - Q(y) + sum_i c_i/2,      d_i = (Q(f(x + e_i)) - Q(f(x - e_i)))/2,
//     C = sum_i (d_i d_i^T + c_i c_i^T/2) + sum_j m_j m_j^T,    c_i = Q(f(x + e_i)) + Q(f(x - e_i)) - 2 Q(f(x)),
// with e_i one standard deviation of an error of the start or of a surface, and m_j half the change of Q(y) from a standard
// deviation down to one up of what was measured.  r is then normal around the true deviation, with covariance C, as far as
// errors act to second order.  Of n numbers in each of k deviations all errors lie in their ellipsoids e^T C^-1 e <= q with a
// probability of 0.95 or more, however they hang together, if q holds chi-squared of n degrees with probability 0.95^(1/k):
// Sidak (1967) for n = 1, for all n by the Gaussian correlation inequality (Royen 2014, Far East J. Theor. Stat. 48, 139).
// So the size of a true deviation lies within sqrt(q largest eigenvalue of C) of |r|, for all of them at once, and so does the
// largest of them.
#pragma once

#include "harness/core/measure.h"

#include <span>
#include <string>
#include <utility>

namespace cylon::core {

/// Recordings of one pair of Uncertainty::scenes: an error up, and down.
using Pushed = std::pair<Recording, Recording>;

/// Why such a claim has no interval: an observable that is no difference of measured numbers, another reduction than max
/// and end, a tolerance that is not absolute alone; or "".
std::string no_interval(const Claim&);

/// The largest deviation, or that at the end, with its interval; `pushed` in the order of the scenes.  The claim validates.
Measured measure_uncertain(const Claim&, const Scene&, const Recording&, std::span<const Pushed> pushed);

}  // namespace cylon::core
