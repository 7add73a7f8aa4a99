// A few numbers side by side: arithmetic on 32 bytes.  Correctly rounded operations alone, and the order of
// every sum is written down, so that one number and a lane of many get the same bits.
#pragma once

#include "engine/vector.h"

#include <cmath>

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace cylon::engine {

inline constexpr int lane_count = 32 / sizeof(Real);

using Lanes = Real __attribute__((vector_size(32)));

[[gnu::always_inline]] inline Lanes spread(Real value) { return Lanes{} + value; }
[[gnu::always_inline]] inline Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }
[[gnu::always_inline]] inline Lanes smaller(Lanes a, Lanes b) { return a < b ? a : b; }

[[gnu::always_inline]] inline Real root(Real a) { return std::sqrt(a); }
[[gnu::always_inline]] inline Lanes root(Lanes a) {
#if defined(__AVX__) && defined(CYLON_ENGINE_FLOAT)
  return _mm256_sqrt_ps(a);
#elif defined(__AVX__)
  return _mm256_sqrt_pd(a);
#else
  for (int i = 0; i < lane_count; ++i) a[i] = std::sqrt(a[i]);
  return a;
#endif
}

/// x, y, z of a number, or of some numbers side by side.
template <class N>
struct Triple {
  N x, y, z;
};

using Lanes3 = Triple<Lanes>;

template <class N>
[[gnu::always_inline]] inline Triple<N> operator+(const Triple<N>& a, const Triple<N>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
[[gnu::always_inline]] inline Triple<N> operator-(const Triple<N>& a, const Triple<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
[[gnu::always_inline]] inline Triple<N> operator*(const N& s, const Triple<N>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class N>
[[gnu::always_inline]] inline N dot(const Triple<N>& a, const Triple<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
[[gnu::always_inline]] inline Triple<N> cross(const Triple<N>& a, const Triple<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace cylon::engine
