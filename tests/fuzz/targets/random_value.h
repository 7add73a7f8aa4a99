// Values that the key tables allow, and some that they only nearly allow.
#pragma once

#include "harness/scenario/keys.h"

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cylon::fuzz {

/// The same numbers on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  std::size_t below(std::size_t n) { return n == 0 ? 0 : bits_() % n; }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  /// A number as TOML has it, in full or with three digits.
  std::string written(double);

 private:
  std::mt19937_64 bits_;
};

/// What may stand behind "key = ".  `names`: what a text may mean.
std::string random_value(const scenario::Key&, const std::vector<std::string>& names, Random&);

/// Keys and values of one table: all that are required, a third of the others.
std::vector<std::pair<std::string, std::string>> random_table(const scenario::Spec&,
                                                              const std::vector<std::string>& names, Random&);

}  // namespace cylon::fuzz
