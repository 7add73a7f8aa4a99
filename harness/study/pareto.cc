#include "harness/study/pareto.h"

#include <algorithm>
#include <cmath>

namespace cylon::study {
namespace {

bool is_point(const Tradeoff& t) { return std::isfinite(t.cost) && std::isfinite(t.error); }

bool dominates(const Tradeoff& a, const Tradeoff& b) {
  return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

}  // namespace

std::vector<Standing> pareto(std::span<const Tradeoff> points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_point(points[i])) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].cost != points[b].cost ? points[a].cost < points[b].cost
                                            : points[a].error < points[b].error;
  });
  // From cheap to dear the front is what lowers the error, and what is equal to its last point.
  std::vector<Standing> standing(points.size());
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (front.empty() || !dominates(points[front.back()], points[i])) {
      standing[i].on_front = true;
      front.push_back(i);
      continue;
    }
    const auto by = std::find_if(front.begin(), front.end(),
                                 [&](std::size_t f) { return dominates(points[f], points[i]); });
    standing[i].by = *by;
  }
  return standing;
}

}  // namespace cylon::study
