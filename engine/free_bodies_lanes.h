// a b + c with one rounding on 32 bytes of numbers, and sine and cosine made of it: the same bits with and
// without the machine's instruction.
#pragma once

#include "engine/lanes.h"

#include <cmath>

namespace cylon::engine::wide {

/// a b + c
[[gnu::always_inline]] inline Lanes add(Lanes a, Lanes b, Lanes c) {
#if defined(__FMA__) && defined(CYLON_ENGINE_FLOAT)
  return _mm256_fmadd_ps(a, b, c);
#elif defined(__FMA__)
  return _mm256_fmadd_pd(a, b, c);
#else
  for (int i = 0; i < lane_count; ++i) c[i] = std::fma(a[i], b[i], c[i]);
  return c;
#endif
}

/// c - a b
[[gnu::always_inline]] inline Lanes take(Lanes a, Lanes b, Lanes c) { return add(-a, b, c); }

/// 1/0!, 1/1!, ... with the signs of the series of sine and cosine.
inline constexpr struct Series {
  Real term[20] = {};
  constexpr Series() {
    double factorial = 1;
    for (int n = 0; n < 20; ++n) {
      factorial *= n > 0 ? n : 1;
      term[n] = static_cast<Real>((n / 2 % 2 == 0 ? 1 : -1) / factorial);
    }
  }
} series;

struct Turn {
  Lanes cosine, sine;
};

/// By the series to x^(2 N + 1) and x^(2 M).
template <std::ptrdiff_t N, std::ptrdiff_t M>
[[gnu::always_inline]] inline Turn by_series(Lanes x) {
  const Lanes xx = x * x;
  Lanes sine = spread(series.term[2 * N + 1]), cosine = spread(series.term[2 * M]);
  for (auto n = N - 1; n > 0; --n) sine = add(sine, xx, spread(series.term[2 * n + 1]));
  for (auto m = M - 1; m >= 0; --m) cosine = add(cosine, xx, spread(series.term[2 * m]));
  return {cosine, add(sine * xx, x, x)};
}

inline constexpr Real small_angle = Real(0.1);

/// |x| <= small_angle.  First terms left out: x^10/10! < 3e-17; in float x^6/6! < 2e-9.
[[gnu::always_inline]] inline Turn small_turn(Lanes x) {
  if constexpr (sizeof(Real) == 8)
    return by_series<4, 4>(x);
  else
    return by_series<2, 2>(x);
}

/// cos and sin of x or of x + pi: as half angles of a rotation they are the same.  |x| < 1e9; 1e5 in float.
/// x/2 less a multiple of pi/2, then the double angle.  First terms left out at pi/4: x^17/17! < 5e-17, in
/// float x^10/10! < 3e-8.
[[gnu::always_inline]] inline Turn half_turn(Lanes x) {
  constexpr bool wide = sizeof(Real) == 8;
  // added and taken away, it leaves the nearest whole number: its last digit is 1
  constexpr Real whole = static_cast<Real>(wide ? 6755399441055744.0 : 12582912.0);
  constexpr Real inverse = static_cast<Real>(0.63661977236758134308);
  constexpr Real high = static_cast<Real>(1.57079632679489661923);
  constexpr Real low = static_cast<Real>(wide ? 6.12323399573676603587e-17 : -4.37113882867379e-8);
  const Lanes half = x * Real(0.5);
  const Lanes k = (half * inverse + whole) - whole;
  const Lanes r = take(k, spread(low), take(k, spread(high), half));
  const Turn t = wide ? by_series<7, 8>(r) : by_series<4, 4>(r);
  return {take(t.sine, t.sine, t.cosine * t.cosine), t.sine * t.cosine * Real(2)};
}

}  // namespace cylon::engine::wide
