// Random numbers that are the same on every machine: no distribution of the standard library, no function that
// a libm rounds as it likes.
#pragma once

#include "harness/core/scene.h"

#include <cstdint>
#include <random>

namespace cylon::hunt {

class Dice {
 public:
  /// Throws `n` of a game: each pair of numbers has a stream of its own.
  Dice(std::uint64_t seed, std::uint64_t n);

  bool one_in(std::uint64_t n) { return bits_() % n == 0; }
  std::size_t below(std::size_t n) { return bits_() % n; }

  /// A number in [low, high] of three digits, which a person can read.
  double between(double low, double high);
  core::Vector3 vector(double size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }

  /// Any direction; any turn.  To rounding of unit length.
  core::Vector3 direction();
  core::Quaternion turn();

  template <class List>
  const auto& of(const List& list) {
    return list[below(std::size(list))];
  }

 private:
  std::mt19937_64 bits_;
};

/// The number nearest to x that has so many decimal digits.
double rounded(double x, int digits);

}  // namespace cylon::hunt
