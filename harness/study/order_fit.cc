#include "harness/study/order_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cylon::study {
namespace {

constexpr double lost = 0.3;  // of a trajectory, a third of its size: no law of small errors holds any more

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

// The median of d log e / d log dt over all pairs: one outlier in four points does not move it.
double slope(std::span<const StepError> points) {
  std::vector<double> slopes;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      slopes.push_back(std::log(points[i].error / points[j].error) / std::log(points[i].dt / points[j].dt));
  return median(slopes);
}

double median_error(std::span<const StepError> points) {
  std::vector<double> errors;
  for (const StepError& p : points) errors.push_back(p.error);
  return median(errors);
}

// Where the floor starts; points.size() where there is none.
std::size_t floor_start(std::span<const StepError> points, double resolution, double epsilon) {
  double largest = 0;
  for (const StepError& p : points) largest = std::max(largest, p.error);
  std::size_t first = points.size();
  for (std::size_t i = 0; i + 2 <= points.size(); ++i) {
    const auto tail = points.subspan(i);
    const double flat = tail.size() == 2 ? 0.25 : 0.4;
    if (median_error(tail) > std::max({0.01 * largest, resolution, std::sqrt(epsilon)}) ||
        slope(tail) >= flat)
      continue;
    first = i;
    break;
  }
  while (first + 2 < points.size() && points[first].error > 10 * median_error(points.subspan(first))) ++first;
  // The last points may be below all that can be told without a flat run.
  while (first > 0 && points[first - 1].error <= resolution) --first;
  return first;
}

}  // namespace

OrderFit fit_order(std::span<const StepError> given, double resolution, double epsilon) {
  std::vector<StepError> points;
  for (const StepError& p : given)
    if (std::isfinite(p.error))
      points.push_back({p.dt, std::max(p.error, 1e-20)});  // an exact zero has a log
  OrderFit fit;
  const std::size_t start = floor_start(points, resolution, epsilon);
  const auto all = std::span<const StepError>(points);
  if (start < points.size()) {
    fit.floor = median_error(all.subspan(start));
    fit.floor_from = points[start].dt;
    // Rounding of n steps grows as n at worst; sensitive motions magnify it by some orders of magnitude.
    fit.rounding = *fit.floor <= std::max(resolution, 10 * std::sqrt(epsilon));
  }
  std::vector<StepError> falling;
  for (const StepError& p : all.first(start))
    if (p.error > 20 * fit.floor.value_or(0) && p.error < lost) falling.push_back(p);
  // A last point that fell far less than those before it is half at the floor.
  const auto last = [&](std::size_t n) { return std::span(falling).last(n); };
  while (falling.size() >= 4 && falling.back().error < std::sqrt(epsilon) &&
         slope(last(2)) < 0.75 * slope(last(4).first(3)))
    falling.pop_back();
  fit.used = std::min<std::size_t>(4, falling.size());
  if (fit.used < 2) return fit;
  const auto used = last(fit.used);
  const auto rises = [](const StepError& coarse, const StepError& fine) {
    return fine.error >= coarse.error;
  };
  const bool noise = used.front().error < std::sqrt(epsilon) &&
                     (used.front().error < 10 * used.back().error ||
                      std::adjacent_find(used.begin(), used.end(), rises) != used.end());
  if (!noise) fit.order = slope(used);
  return fit;
}

}  // namespace cylon::study
