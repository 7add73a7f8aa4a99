#include "harness/tracking/statistics/hodges_lehmann.h"

#include "harness/tracking/statistics/signed_rank.h"

#include <algorithm>
#include <vector>

namespace cylon::statistics {
namespace {

std::vector<double> walsh_averages(std::span<const double> x) {
  std::vector<double> averages;
  averages.reserve(x.size() * (x.size() + 1) / 2);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = i; j < x.size(); ++j) averages.push_back(x[i] / 2 + x[j] / 2);
  return averages;
}

double nth(std::vector<double>& values, std::size_t n) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(n);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

double hodges_lehmann(std::span<const double> x) {
  std::vector<double> averages = walsh_averages(x);
  const std::size_t m = averages.size();
  if (m == 0) return std::numeric_limits<double>::quiet_NaN();
  return nth(averages, (m - 1) / 2) / 2 + nth(averages, m / 2) / 2;
}

Interval hodges_lehmann_interval(std::span<const double> x, double tail) {
  std::vector<int> doubled;
  for (std::size_t rank = 1; rank <= x.size(); ++rank) doubled.push_back(static_cast<int>(2 * rank));
  const SignedRankDistribution w(doubled);
  std::vector<double> averages = walsh_averages(x);
  int k = 0;
  while (w.at_most(2 * k) <= tail && 2 * k < static_cast<int>(averages.size())) ++k;
  if (k == 0) return {};
  const auto below = static_cast<std::size_t>(k) - 1;
  return {nth(averages, below), nth(averages, averages.size() - 1 - below)};
}

}  // namespace cylon::statistics
