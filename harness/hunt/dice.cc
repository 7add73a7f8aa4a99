#include "harness/hunt/dice.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

namespace cylon::hunt {
namespace {

// Steele, Lea and Flood (2014), SplitMix64: neighbours get streams that have nothing in common.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

}  // namespace

double rounded(double x, int digits) {
  const std::string text = fmt::format("{:.{}e}", x, digits - 1);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

Dice::Dice(std::uint64_t seed, std::uint64_t n) : bits_(mixed(mixed(seed) ^ n)) {}

double Dice::between(double low, double high) {
  const double u = static_cast<double>(bits_() >> 11) * 0x1p-53;
  return rounded(low + (high - low) * u, 3);
}

core::Vector3 Dice::direction() {
  for (;;) {
    const core::Vector3 v = vector(1);
    const double square = v.squaredNorm();
    if (square > 0.01 && square <= 1) return v / std::sqrt(square);
  }
}

core::Quaternion Dice::turn() {
  for (;;) {
    const core::Quaternion q(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1));
    const double square = q.squaredNorm();
    if (square > 0.01 && square <= 1) return core::Quaternion(q.coeffs() / std::sqrt(square));
  }
}

}  // namespace cylon::hunt
