// Rigorous bounds in double: sums and products of what is not negative, raised above their rounding.
#pragma once

#include <cmath>

namespace cylon::certified {

/// Above x by more than a thousand roundings of operations on non-negative numbers, underflow included.
inline double above(double x) { return x * (1 + 0x1p-42) + 1e-300; }
inline double below(double x) { return x * (1 - 0x1p-42) - 1e-300; }

/// A real number, or all of a set of them: |x - middle| <= radius.
struct Near {
  double middle = 0, radius = 0;
  double largest() const { return above(std::abs(middle) + radius); }
};

}  // namespace cylon::certified
