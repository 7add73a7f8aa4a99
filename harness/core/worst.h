#pragma once

#include <cmath>

namespace cylon::core {

/// The larger of two magnitudes, or NaN where either is: std::max drops it, and a blown-up run would pass.
inline double worst(double a, double b) { return std::isnan(a) || a > b ? a : b; }

}  // namespace cylon::core
