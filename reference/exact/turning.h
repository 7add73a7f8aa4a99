// Where a motion in one variable turns: the roots of a polynomial on either side of the present value.
#pragma once

#include "reference/exact/wide.h"

#include <span>

namespace cylon::exact {

/// Present value plus `down` <= 0 and `up` >= 0.
struct TurningPoints {
  Wide down, up;
};

/// Roots of f(x) = c[0] + c[1] x + … next to x = 0 on either side, where f is the square of a rate: f(0) >=
/// 0, f(lo) <= 0, f(hi) <= 0, lo <= 0 <= hi, and one root between 0 and each end.  Written about the present
/// value, so that a start at a turning point (c[0] = 0) or at rest in both (c[1] = 0) is no special case.
/// Newton's method kept in its bracket; relative error of a few 1e-19 for simple roots.
TurningPoints turning_points(std::span<const Wide> c, Wide lo, Wide hi);

}  // namespace cylon::exact
