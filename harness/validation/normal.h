// Normal numbers that are the same on every machine.
#pragma once

#include "harness/core/scene.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace cylon::validation {

/// Box and Muller (1958), from 53 bits each.
class Normal {
 public:
  Normal(std::uint64_t seed, std::uint64_t run, std::uint64_t member) {
    std::seed_seq words{seed >> 32, seed & 0xffffffff, run, member};
    bits_.seed(words);
  }
  double operator()(double deviation) {
    const double radius = std::sqrt(-2 * std::log1p(-unit())), turn = 2 * std::numbers::pi * unit();
    return deviation * radius * std::cos(turn);
  }
  /// Chi-squared of so many degrees: twice a gamma variable of half of them (Marsaglia and Tsang 2000, ACM TOMS 26, 363).
  double chi_squared(double freedom) {
    const double a = freedom / 2;
    if (a < 1) return chi_squared(freedom + 2) * std::pow(1 - unit(), 1 / a);
    const double d = a - 1.0 / 3, c = 1 / std::sqrt(9 * d);
    while (true) {
      const double x = (*this)(1), v = std::pow(1 + c * x, 3), u = 1 - unit();
      if (v > 0 && std::log(u) < x * x / 2 + d - d * v + d * std::log(v)) return 2 * d * v;
    }
  }
  core::Vector3 vector(double deviation) {
    const double x = (*this)(deviation), y = (*this)(deviation), z = (*this)(deviation);
    return {x, y, z};
  }

 private:
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }  // [0, 1)
  std::mt19937_64 bits_;
};

}  // namespace cylon::validation
