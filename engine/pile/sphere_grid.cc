#include "engine/pile/sphere_grid.h"

#include <limits>
#include <utility>

namespace cylon::engine::pile {

void SphereGrid::build(const Spheres& spheres, const std::vector<Real>& reach) {
  const int n = spheres.count;
  const auto count = static_cast<std::size_t>(n);
  constexpr Real far = std::numeric_limits<Real>::max();
  Real largest = std::numeric_limits<Real>::min(), high[3] = {-far, -far, -far}, sum[3] = {};
  for (Real& low : low_) low = far;
  int inside = 0;
  for (int i = 0; i < n; ++i) {
    if (!(reach[static_cast<std::size_t>(i)] >= 0)) continue;
    ++inside;
    largest = std::max(largest, reach[static_cast<std::size_t>(i)]);
    for (int c = 0; c < 3; ++c) {
      const Real at = spheres.p(i)[c];
      low_[c] = std::min(low_[c], at), high[c] = std::max(high[c], at), sum[c] += at;
    }
  }
  // Far stragglers share the cells at the border, which stays right because clamping keeps neighbours
  // neighbours; the cells stand around the mean.
  const Real edge = 2 * largest * Real(1.0001);
  inverse_size_ = 1 / edge;
  const Real most = static_cast<Real>(16 * n + 4096);
  Real cells[3];
  for (int c = 0; c < 3; ++c) cells[c] = inside > 0 ? std::floor((high[c] - low_[c]) * inverse_size_) + 1 : 1;
  while (!(cells[0] * cells[1] * cells[2] <= most)) {
    const int c = cells[0] >= cells[1] && cells[0] >= cells[2] ? 0 : cells[1] >= cells[2] ? 1 : 2;
    cells[c] = std::min(std::ceil(cells[c] / 2), most);
    low_[c] = std::max(low_[c], sum[c] / static_cast<Real>(inside) - cells[c] / 2 * edge);
  }
  for (int c = 0; c < 3; ++c) size_[c] = std::max(1, static_cast<int>(cells[c]));

  start_.assign(static_cast<std::size_t>(std::ptrdiff_t{size_[0]} * size_[1] * size_[2]) + 1, 0);
  cell_.resize(count), index_.resize(count + lane_count);
  for (Aligned<Real>* values : {&x_, &y_, &z_, &reach_}) values->resize(count + lane_count);
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!(reach[k] >= 0)) continue;
    const Real* p = spheres.p(i);
    cell_[k] = (cell(2, p[2]) * size_[1] + cell(1, p[1])) * size_[0] + cell(0, p[0]);
    ++start_[static_cast<std::size_t>(cell_[k])];
  }
  fullest_ = *std::max_element(start_.begin(), start_.end());
  int total = 0;
  for (int& start : start_) start = std::exchange(total, total + start);
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!(reach[k] >= 0)) continue;
    const auto to = static_cast<std::size_t>(start_[static_cast<std::size_t>(cell_[k])]++);
    const Real* p = spheres.p(i);
    x_[to] = p[0], y_[to] = p[1], z_[to] = p[2], reach_[to] = reach[k], index_[to] = i;
  }
  for (std::size_t k = start_.size() - 1; k > 0; --k) start_[k] = start_[k - 1];
  start_[0] = 0;
}

}  // namespace cylon::engine::pile
