#include "harness/tracking/statistics/change_points.h"

#include "harness/tracking/statistics/energy_distance.h"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace cylon::statistics {
namespace {

double mean(std::span<const double> x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

double squares(std::span<const double> x, double about) {
  return std::accumulate(x.begin(), x.end(), 0.0,
                         [&](double sum, double one) { return sum + (one - about) * (one - about); });
}

// Student's t of two samples: t = (mean_b - mean_a) / (s sqrt(1/n_a + 1/n_b)), with s the pooled deviation of
// n_a + n_b - 2 degrees of freedom.  Values that repeat exactly differ surely or not at all.  The cut is the
// best of `choices`, so p is multiplied by their number (Bonferroni).
ChangePoint compare(std::span<const double> series, std::size_t first, std::size_t cut, std::size_t last,
                    double choices) {
  const auto a = series.subspan(first, cut - first), b = series.subspan(cut, last - cut);
  const double mean_a = mean(a), mean_b = mean(b), difference = mean_b - mean_a;
  const auto n_a = static_cast<double>(a.size()), n_b = static_cast<double>(b.size());
  const double freedom = n_a + n_b - 2;
  if (freedom < 1) return {cut, difference, {}, 1.0};
  const double s = std::sqrt((squares(a, mean_a) + squares(b, mean_b)) / freedom);
  const double deviation = s * std::sqrt(1 / n_a + 1 / n_b);
  if (deviation == 0) return {cut, difference, {difference, difference}, difference == 0 ? 1.0 : 0.0};
  const boost::math::students_t distribution(freedom);
  const double single = 2 * cdf(complement(distribution, std::abs(difference) / deviation));
  const double p = std::min(1.0, single * choices);
  const double half = deviation * quantile(complement(distribution, 0.005));
  return {cut, difference, {difference - half, difference + half}, p};
}

// Cuts with `shortest` values on either side, of so many.
double cuts_of(std::size_t count, std::size_t shortest) {
  return std::max(1.0, static_cast<double>(count) + 1 - 2 * static_cast<double>(shortest));
}

struct Cut {
  std::size_t at, end;
};

// Where x_0 … x_{end-1} is cut best, over all ends: a level that returns to the one before is not hidden by
// what follows it.
Cut best_cut(std::span<const double> x, std::size_t shortest) {
  const auto margin = static_cast<std::ptrdiff_t>(shortest);
  Cut best{0, 0};
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t end = 2 * shortest; end <= x.size(); ++end) {
    const std::vector<double> q = energy_of_cuts(x.first(end));
    const auto cut = std::max_element(q.begin() + margin, q.end() - margin);
    if (*cut > largest) largest = *cut, best = {static_cast<std::size_t>(cut - q.begin()), end};
  }
  return best;
}

// E-divisive within first … last: the points, in order.
void split(std::span<const double> series, std::size_t first, std::size_t last, const ChangePointRule& rule,
           std::vector<std::size_t>& points) {
  if (last - first < 2 * rule.shortest) return;
  const Cut best = best_cut(series.subspan(first, last - first), rule.shortest);
  const std::size_t cut = first + best.at;
  const double ends = cuts_of(last - first, rule.shortest), choices = ends * (ends + 1) / 2;
  if (compare(series, first, cut, first + best.end, choices).p >= 10 * rule.max_p) return;
  split(series, first, cut, rule, points);
  points.push_back(cut);
  split(series, cut, last, rule, points);
}

// Windows overlap by half, and start anew at the last point found, where a level begins.
std::vector<std::size_t> propose(std::span<const double> series, const ChangePointRule& rule) {
  std::vector<std::size_t> points;
  for (std::size_t start = 0; start < series.size();) {
    std::vector<std::size_t> found;
    split(series, start, std::min(start + rule.window, series.size()), rule, found);
    start = std::max(found.empty() ? 0 : found.back(), start + std::max<std::size_t>(1, rule.window / 2));
    points.insert(points.end(), found.begin(), found.end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}  // namespace

std::vector<ChangePoint> change_points(std::span<const double> series, const ChangePointRule& rule) {
  for (const double one : series)
    if (!std::isfinite(one)) throw std::invalid_argument("a ratio is not finite");
  const double min_magnitude = std::log1p(rule.min_magnitude);
  std::vector<std::size_t> cuts = propose(series, rule);
  while (true) {
    std::vector<ChangePoint> points;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      const std::size_t first = i == 0 ? 0 : cuts[i - 1];
      const std::size_t last = i + 1 == cuts.size() ? series.size() : cuts[i + 1];
      points.push_back(compare(series, first, cuts[i], last, cuts_of(last - first, rule.shortest)));
    }
    if (points.empty()) return points;
    auto weakest = std::max_element(points.begin(), points.end(),
                                    [](const ChangePoint& a, const ChangePoint& b) { return a.p < b.p; });
    if (weakest->p < rule.max_p)
      weakest =
          std::min_element(points.begin(), points.end(), [](const ChangePoint& a, const ChangePoint& b) {
            return std::abs(a.magnitude) < std::abs(b.magnitude);
          });
    if (weakest->p < rule.max_p && std::abs(weakest->magnitude) >= min_magnitude) return points;
    cuts.erase(cuts.begin() + (weakest - points.begin()));
  }
}

}  // namespace cylon::statistics
