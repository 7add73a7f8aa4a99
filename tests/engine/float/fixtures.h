// The models of tests/engine in single precision, and what rounding is worth in it.
#pragma once

// Their constants are written as doubles, which are rounded here: that they are no longer the same is meant.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wfloat-conversion"
#include "tests/engine/fixtures.h"
#pragma GCC diagnostic pop

namespace cylon::engine {

static_assert(sizeof(Real) == sizeof(float), "this suite is for the engine in single precision");

inline constexpr Real rounding = std::numeric_limits<Real>::epsilon();
inline Real real(double x) { return static_cast<Real>(x); }

inline bool finite(const std::vector<Motion>& motions) {
  return std::all_of(motions.begin(), motions.end(), [](const Motion& m) {
    return m.position.allFinite() && m.momentum.allFinite() && m.orientation.coeffs().allFinite() &&
           m.angular_momentum.allFinite();
  });
}

}  // namespace cylon::engine
