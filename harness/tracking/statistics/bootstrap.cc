#include "harness/tracking/statistics/bootstrap.h"

#include "harness/tracking/statistics/quantile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

namespace cylon::statistics {
namespace {

// Phi(-sqrt(n/(n - 1)) t), Phi the normal distribution.
double expanded(double tail, double n) {
  return std::erfc(std::sqrt(n / (n - 1) / 2) * student_quantile(tail, n - 1)) / 2;
}

}  // namespace

double median(std::span<const double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> copy(values.begin(), values.end());
  const auto middle = copy.begin() + static_cast<std::ptrdiff_t>(copy.size() / 2);
  std::nth_element(copy.begin(), middle, copy.end());
  if (copy.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(copy.begin(), middle)) / 2;
}

double mean(std::span<const double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Interval bootstrap(std::span<const double> values,
                   const std::function<double(std::span<const double>)>& estimate, double tail,
                   std::uint64_t seed, int draws) {
  if (!(tail > 0 && tail < 0.5) || draws * tail < 2)
    throw std::invalid_argument("a bootstrap needs 0 < tail < 1/2 and at least 2/tail draws");
  const auto n = static_cast<double>(values.size());
  if (std::exp2(-n) > tail) return {};
  std::mt19937_64 bits(seed);
  std::vector<double> sample(values.size()), found;
  for (int i = 0; i < draws; ++i) {
    for (double& x : sample)
      x = values[bits() % values.size()];  // the remainder favours none by more than 2^-50
    found.push_back(estimate(sample));
  }
  std::ranges::sort(found);
  const auto cut = std::max<std::size_t>(1, static_cast<std::size_t>(std::floor(expanded(tail, n) * draws)));
  return {found[cut - 1], found[found.size() - cut]};
}

}  // namespace cylon::statistics
