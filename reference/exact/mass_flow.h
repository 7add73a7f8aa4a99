// Functions of x = (dm/dt) t/m0, the relative change of mass, that the motion of a body of changing mass
// needs: integrals of 1/(1 + x), kept from cancelling where little has flowed.
#pragma once

#include "reference/exact/wide.h"

namespace cylon::exact {

/// ln(1 + x)/x, x > -1; 1 at 0.
inline Wide log_ratio(Wide x) { return x == 0 ? 1 : std::log1p(x) / x; }

/// ((1 + x) ln(1 + x) - x)/x^2 = 1/2 - x/6 + x^2/12 - …, x > -1.
inline Wide log_integral(Wide x) {
  if (std::abs(x) > 0.25L) return ((1 + x) * std::log1p(x) - x) / (x * x);
  Wide sum = 0, power = 1;
  for (int n = 2; n <= 36; ++n, power *= -x) sum += power / static_cast<Wide>(n * (n - 1));
  return sum;
}

/// (x + x^2/2 - ln(1 + x))/(2 x^2) = 1/2 - x/6 + x^2/8 - x^3/10 + …, x > -1.
inline Wide weight_integral(Wide x) {
  if (std::abs(x) > 0.25L) return (x + x * x / 2 - std::log1p(x)) / (2 * x * x);
  Wide sum = 1, power = -x;
  for (int n = 3; n <= 36; ++n, power *= -x) sum += power / static_cast<Wide>(n);
  return sum / 2;
}

}  // namespace cylon::exact
