// Rows of four numbers read into and out of lanes, and lanes picked.
#pragma once

#include "engine/lanes.h"

#include <bit>

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace cylon::engine::pile {

#if defined(__AVX__) && !defined(CYLON_ENGINE_FLOAT)

/// Numbers 4 k .. 4 k + 3 of a row of `stride`, of the rows named, one row a lane.
[[gnu::always_inline]] inline void load(const Real* rows, const int* row, std::ptrdiff_t stride, Lanes& a,
                                        Lanes& b, Lanes& c, Lanes& d) {
  const __m256d r0 = _mm256_load_pd(rows + stride * row[0]), r1 = _mm256_load_pd(rows + stride * row[1]),
                r2 = _mm256_load_pd(rows + stride * row[2]), r3 = _mm256_load_pd(rows + stride * row[3]);
  const __m256d t0 = _mm256_unpacklo_pd(r0, r1), t1 = _mm256_unpackhi_pd(r0, r1),
                t2 = _mm256_unpacklo_pd(r2, r3), t3 = _mm256_unpackhi_pd(r2, r3);
  a = _mm256_permute2f128_pd(t0, t2, 0x20), b = _mm256_permute2f128_pd(t1, t3, 0x20);
  c = _mm256_permute2f128_pd(t0, t2, 0x31), d = _mm256_permute2f128_pd(t1, t3, 0x31);
}

[[gnu::always_inline]] inline void store(Real* rows, const int* row, std::ptrdiff_t stride, Lanes a, Lanes b,
                                         Lanes c, Lanes d) {
  const __m256d t0 = _mm256_unpacklo_pd(a, b), t1 = _mm256_unpackhi_pd(a, b), t2 = _mm256_unpacklo_pd(c, d),
                t3 = _mm256_unpackhi_pd(c, d);
  _mm256_store_pd(rows + stride * row[0], _mm256_permute2f128_pd(t0, t2, 0x20));
  _mm256_store_pd(rows + stride * row[1], _mm256_permute2f128_pd(t1, t3, 0x20));
  _mm256_store_pd(rows + stride * row[2], _mm256_permute2f128_pd(t0, t2, 0x31));
  _mm256_store_pd(rows + stride * row[3], _mm256_permute2f128_pd(t1, t3, 0x31));
}

#elif defined(__AVX__)

[[gnu::always_inline]] inline __m256 two_rows(const Real* low, const Real* high) {
  return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(low)), _mm_load_ps(high), 1);
}

/// Numbers 4 k .. 4 k + 3 of a row of `stride`, of the rows named, one row a lane.
[[gnu::always_inline]] inline void load(const Real* rows, const int* row, std::ptrdiff_t stride, Lanes& a,
                                        Lanes& b, Lanes& c, Lanes& d) {
  const auto at = [&](int lane) { return rows + stride * row[lane]; };
  const __m256 r0 = two_rows(at(0), at(4)), r1 = two_rows(at(1), at(5)), r2 = two_rows(at(2), at(6)),
               r3 = two_rows(at(3), at(7));
  const __m256 t0 = _mm256_unpacklo_ps(r0, r1), t1 = _mm256_unpackhi_ps(r0, r1),
               t2 = _mm256_unpacklo_ps(r2, r3), t3 = _mm256_unpackhi_ps(r2, r3);
  a = _mm256_shuffle_ps(t0, t2, 0x44), b = _mm256_shuffle_ps(t0, t2, 0xee);
  c = _mm256_shuffle_ps(t1, t3, 0x44), d = _mm256_shuffle_ps(t1, t3, 0xee);
}

[[gnu::always_inline]] inline void store(Real* rows, const int* row, std::ptrdiff_t stride, Lanes a, Lanes b,
                                         Lanes c, Lanes d) {
  const __m256 t0 = _mm256_unpacklo_ps(a, b), t1 = _mm256_unpackhi_ps(a, b), t2 = _mm256_unpacklo_ps(c, d),
               t3 = _mm256_unpackhi_ps(c, d);
  const auto put = [&](int lane, __m256 value) {
    _mm_store_ps(rows + stride * row[lane], _mm256_castps256_ps128(value));
    _mm_store_ps(rows + stride * row[lane + 4], _mm256_extractf128_ps(value, 1));
  };
  put(0, _mm256_shuffle_ps(t0, t2, 0x44)), put(1, _mm256_shuffle_ps(t0, t2, 0xee));
  put(2, _mm256_shuffle_ps(t1, t3, 0x44)), put(3, _mm256_shuffle_ps(t1, t3, 0xee));
}

#else

/// Numbers 4 k .. 4 k + 3 of a row of `stride`, of the rows named, one row a lane.
[[gnu::always_inline]] inline void load(const Real* rows, const int* row, std::ptrdiff_t stride, Lanes& a,
                                        Lanes& b, Lanes& c, Lanes& d) {
  for (int i = 0; i < lane_count; ++i) {
    const Real* from = rows + stride * row[i];
    a[i] = from[0], b[i] = from[1], c[i] = from[2], d[i] = from[3];
  }
}

[[gnu::always_inline]] inline void store(Real* rows, const int* row, std::ptrdiff_t stride, Lanes a, Lanes b,
                                         Lanes c, Lanes d) {
  for (int i = 0; i < lane_count; ++i) {
    Real* to = rows + stride * row[i];
    to[0] = a[i], to[1] = b[i], to[2] = c[i], to[3] = d[i];
  }
}

#endif

/// A comparison's outcome: bit k is lane k.
template <class Mask>
[[gnu::always_inline]] inline unsigned signs(Mask mask) {
#if defined(__AVX__) && defined(CYLON_ENGINE_FLOAT)
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#elif defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask)));
#else
  unsigned bits = 0;
  for (int lane = 0; lane < lane_count; ++lane) bits |= static_cast<unsigned>(mask[lane] != 0) << lane;
  return bits;
#endif
}

/// Row k: the places of the ones of k, in order, then anything.
struct Selection {
  alignas(32) int place[1 << lane_count][lane_count] = {};
  constexpr Selection() {
    for (int bits = 0; bits < 1 << lane_count; ++bits)
      for (int lane = 0, n = 0; lane < lane_count; ++lane)
        if ((bits >> lane & 1) != 0) place[bits][n++] = lane;
  }
};
inline constexpr Selection selection;

/// Writes those of `values` whose bit is set and that are greater than `least` to `to`, without branching,
/// and returns their number; writes lane_count numbers.
[[gnu::always_inline]] inline int take_later(unsigned bits, const int* values, int least, int* to) {
#if defined(__AVX2__) && defined(CYLON_ENGINE_FLOAT)
  const __m256i all = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(values));
  bits &= signs(_mm256_castsi256_ps(_mm256_cmpgt_epi32(all, _mm256_set1_epi32(least))));
  const __m256i order = _mm256_load_si256(reinterpret_cast<const __m256i*>(selection.place[bits]));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permutevar8x32_epi32(all, order));
#elif defined(__AVX2__)
  const __m128i all = _mm_loadu_si128(reinterpret_cast<const __m128i*>(values));
  const __m128i later = _mm_cmpgt_epi32(all, _mm_set1_epi32(least));
  bits &= static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(later)));
  const __m128i order = _mm_load_si128(reinterpret_cast<const __m128i*>(selection.place[bits]));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to),
                   _mm_castps_si128(_mm_permutevar_ps(_mm_castsi128_ps(all), order)));
#else
  for (int lane = 0; lane < lane_count; ++lane)
    bits &= ~(static_cast<unsigned>(values[lane] <= least) << lane);
  for (int lane = 0, n = 0; lane < lane_count; ++lane)
    if ((bits >> lane & 1) != 0) to[n++] = values[lane];
#endif
  return std::popcount(bits);
}

}  // namespace cylon::engine::pile
