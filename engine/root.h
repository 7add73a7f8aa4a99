// Roots of a function of one variable in a bracket.
#pragma once

#include "engine/vector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

/// A root of f between low and high, to rounding of the larger.  Requires f(low) and f(high) of opposite
/// signs (zero counts as either).  Ridders' method: f is straightened by an exponential, each step at least
/// halves the bracket and doubles the digits.  C. J. F. Ridders, IEEE Trans. Circuits Syst. 26 (1979) 979.
template <class Function>
Real root(Function&& f, Real low, Real f_low, Real high, Real f_high) {
  const Real tolerance = epsilon * std::max(std::abs(low), std::abs(high));
  Real best = std::abs(f_low) < std::abs(f_high) ? low : high;
  if (f_low == 0 || f_high == 0) return best;
  // Each round at least halves the bracket, which begins no wider than twice its larger end: after 1 - log2(epsilon), 53
  // in double, it is below the tolerance, and 60 are never made.
  for (int i = 0; i < 60 && high - low > tolerance; ++i) {
    const Real middle = low + (high - low) / 2;
    const Real f_middle = f(middle);
    if (f_middle == 0) return middle;
    const Real s = std::sqrt(f_middle * f_middle - f_low * f_high);
    const Real previous = best;
    best = middle + (middle - low) * (f_low > f_high ? f_middle : -f_middle) / s;
    if (!(best > low && best < high)) best = middle;
    const Real f_best = best == middle ? f_middle : f(best);
    if (f_best == 0 || (i > 0 && std::abs(best - previous) <= tolerance)) return best;

    const auto take = [&](Real t, Real f_t) {  // the side on which f has the same sign
      if ((f_t > 0) == (f_low > 0)) {
        if (t > low) low = t, f_low = f_t;
      } else if (t < high) {
        high = t, f_high = f_t;
      }
    };
    take(middle, f_middle);
    take(best, f_best);
  }
  return best;
}

}  // namespace cylon::engine
