#pragma once

#include <limits>

namespace cylon::statistics {

/// A closed interval; the default knows nothing.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  bool within(double bound) const { return -bound < low && high < bound; }
};

}  // namespace cylon::statistics
