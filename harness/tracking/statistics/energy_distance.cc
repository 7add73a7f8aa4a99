#include "harness/tracking/statistics/energy_distance.h"

#include <cmath>
#include <limits>

namespace cylon::statistics {

// The three sums change by one value's distances when the cut moves past it.
std::vector<double> energy_of_cuts(std::span<const double> x) {
  const std::size_t size = x.size();
  std::vector<double> q(size + 1, -std::numeric_limits<double>::infinity());
  double between = 0, left = 0, right = 0;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = i + 1; k < size; ++k) right += std::abs(x[i] - x[k]);
  for (std::size_t cut = 1; cut < size; ++cut) {
    double to_left = 0, to_right = 0;  // of the value that the cut passes
    for (std::size_t i = 0; i + 1 < cut; ++i) to_left += std::abs(x[i] - x[cut - 1]);
    for (std::size_t i = cut; i < size; ++i) to_right += std::abs(x[i] - x[cut - 1]);
    between += to_right - to_left;
    left += to_left;
    right -= to_right;
    const auto n = static_cast<double>(cut), m = static_cast<double>(size - cut);
    if (n < 2 || m < 2) continue;
    q[cut] = n * m / (n + m) * (2 / (n * m) * between - 2 / (n * (n - 1)) * left - 2 / (m * (m - 1)) * right);
  }
  return q;
}

}  // namespace cylon::statistics
