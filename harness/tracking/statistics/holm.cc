#include "harness/tracking/statistics/holm.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace cylon::statistics {

std::vector<double> holm(std::span<const double> p) {
  for (const double one : p)
    if (!(one >= 0 && one <= 1)) throw std::invalid_argument("a p value is outside [0, 1]");
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size());
  double largest = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto left = static_cast<double>(order.size() - i);
    largest = std::max(largest, std::min(1.0, left * p[order[i]]));
    adjusted[order[i]] = largest;
  }
  return adjusted;
}

}  // namespace cylon::statistics
