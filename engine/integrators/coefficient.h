// The number type of the integrators' coefficients.
#pragma once

#include "engine/vector.h"

#include <array>
#include <cstddef>

namespace cylon::engine {

/// That of the instants: double in both builds of the engine, so that single precision loses nothing to it.
using Coefficient = Time;

/// Coefficients as their sources print them, rounded once.
template <std::size_t N>
constexpr std::array<Coefficient, N> rounded(const std::array<long double, N>& printed) {
  std::array<Coefficient, N> result{};
  for (std::size_t i = 0; i < N; ++i) result[i] = static_cast<Coefficient>(printed[i]);
  return result;
}

}  // namespace cylon::engine
