// Divided differences of the exponential: what every linear equation of motion with constant coefficients
// is solved by, smooth where roots meet (critical damping, resonance, no damping at all).
#pragma once

#include "reference/exact/wide.h"

#include <complex>

namespace cylon::exact {

using WideComplex = std::complex<Wide>;

/// [a, b] of x -> exp(x t): (exp(a t) - exp(b t))/(a - b); t exp(a t) where a = b.  Any order of a, b;
/// t >= 0 [s].  Relative error of a few 1e-19; no overflow where the real parts are not positive.
WideComplex exponential_difference(WideComplex a, WideComplex b, Wide t);

/// [a, b, c] of x -> exp(x t): ([a, b] - [b, c])/(a - c), symmetric in a, b, c; its limit where they meet.
/// It is the response at rest of x'' - (a + b) x' + a b x = exp(c t).
WideComplex exponential_difference(WideComplex a, WideComplex b, WideComplex c, Wide t);

}  // namespace cylon::exact
