// Whether motions agree to the last bit: unlike ==, -0 is not 0 and NaN is itself.
#pragma once

#include "engine/body.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace cylon::engine {

inline bool same_bits(std::span<const Motion> a, std::span<const Motion> b) {
  const auto x = std::as_bytes(a), y = std::as_bytes(b);
  return std::equal(x.begin(), x.end(), y.begin(), y.end());
}

inline bool same_bits(const Motion& a, const Motion& b) {
  return same_bits(std::span(&a, 1), std::span(&b, 1));
}

}  // namespace cylon::engine
