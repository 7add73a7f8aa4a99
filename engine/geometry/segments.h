// The nearest points of two segments.
#pragma once

#include "engine/vector.h"

#include <algorithm>
#include <limits>

namespace cylon::engine {

/// Where on the segments: origin + s direction.
struct SegmentPoints {
  Real s = 0, t = 0;
  bool parallel = false;       ///< To rounding.
  Real low_s = 0, high_s = 0;  ///< Parallel: the part of the first that is beside the second, if low < high.
};

/// Segments p + s u and q + t w with unit u, w and s in [-a, a], t in [-b, b].  The part of w across u is
/// taken first (one step of Gram and Schmidt), which is stable for segments as parallel as rounding allows,
/// where the usual 1 - (u.w)^2 has no digit left.  C. Ericson, Real-Time Collision Detection (2005), 5.1.9.
inline SegmentPoints nearest_on_segments(const Vector3& p, const Vector3& u, Real a, const Vector3& q,
                                         const Vector3& w, Real b) {
  const auto clamped = [](Real x, Real most) { return std::clamp(x, -most, most); };
  const Vector3 d = q - p;
  const Vector3 across = w - u * u.dot(w);
  const Real sine2 = across.squaredNorm();
  constexpr Real least = 8 * epsilon;
  SegmentPoints result;
  if (sine2 <= least * least) {
    const Real middle = u.dot(d);
    result.parallel = true;
    result.low_s = std::max(-a, middle - b), result.high_s = std::min(a, middle + b);
    result.s = clamped((result.low_s + result.high_s) / 2, a);
    result.t = clamped(w.dot(p + result.s * u - q), b);
    return result;
  }
  // min |d + t w - s u|: t from the parts across u, then s, then t again where s had to be cut.
  result.t = clamped(-across.dot(d) / sine2, b);
  result.s = u.dot(d + result.t * w);
  if (std::abs(result.s) > a) {
    result.s = clamped(result.s, a);
    result.t = clamped(w.dot(result.s * u - d), b);
  }
  return result;
}

}  // namespace cylon::engine
