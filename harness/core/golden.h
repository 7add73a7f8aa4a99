// Numbers that are spread evenly, however many, and that no period meets again and again.
#pragma once

#include <cmath>
#include <numbers>

namespace cylon::core {

/// frac(i (sqrt 5 - 1)/2), in [0, 1): the additive recurrence of the golden ratio.
inline double golden_part(int i) {
  const double turns = i * (std::numbers::phi - 1);
  return turns - std::floor(turns);
}

}  // namespace cylon::core
