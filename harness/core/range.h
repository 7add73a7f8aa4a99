// Ranges of numbers.
#pragma once

#include <limits>

namespace cylon::core {

/// low <= x <= high, or low < x where `open`.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open = false;
};
inline constexpr Range any;
inline constexpr Range positive{.low = 0, .open = true};
inline constexpr Range not_negative{.low = 0};
inline constexpr Range unit_interval{.low = 0, .high = 1};

}  // namespace cylon::core
