// Sums over the stages of a Runge-Kutta method, with coefficients that the compiler knows.
#pragma once

#include "engine/integrators/coefficient.h"

#include <cstddef>
#include <utility>

namespace cylon::engine {

/// sum_j C::at(j) k_j[i] over the first N stages, in order; coefficients that are 0 cost nothing.
/// k holds one stage after another, n Reals each.
template <class C, std::size_t N>
inline Real combination(const Real* k, std::size_t n, std::size_t i) {
  Real sum = 0;
  [&]<std::size_t... J>(std::index_sequence<J...>) {
    const auto add = [&]<std::size_t j>(std::integral_constant<std::size_t, j>) {
      if constexpr (C::at(j) != 0) sum += static_cast<Real>(C::at(j)) * k[j * n + i];
    };
    (add(std::integral_constant<std::size_t, J>{}), ...);
  }
  (std::make_index_sequence<N>{});
  return sum;
}

/// Entries of an array of coefficients from `offset` on.
template <const auto& array, std::size_t offset = 0>
struct Entries {
  static constexpr Coefficient at(std::size_t j) { return array[offset + j]; }
};

}  // namespace cylon::engine
