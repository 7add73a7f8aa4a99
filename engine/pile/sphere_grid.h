// Which spheres may touch within a step: a uniform grid, sorted anew every step by counting, whose rows of
// cells along x are contiguous.
#pragma once

#include "engine/pile/spheres.h"

#include <algorithm>
#include <cmath>

namespace cylon::engine::pile {

class SphereGrid {
 public:
  /// Two spheres are near when their centres are closer than the sum of their reaches.  A negative reach:
  /// never near.
  void build(const Spheres&, const std::vector<Real>& reach);

  /// Calls f(j) for every j > i that is near i, in an order that only the positions decide.
  template <class F>
  void near(int i, const Real* place, Real reach, F&& f) const {
    if (reach < 0) return;
    const int x = cell(0, place[0]), y = cell(1, place[1]), z = cell(2, place[2]);
    const int x_low = std::max(x - 1, 0), x_high = std::min(x + 1, size_[0] - 1);
    for (int k = std::max(z - 1, 0); k <= std::min(z + 1, size_[2] - 1); ++k)
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size_[1] - 1); ++j) {
        const int row = (k * size_[1] + j) * size_[0];
        row_of_cells(i, place, reach, start_[static_cast<std::size_t>(row + x_low)],
                     start_[static_cast<std::size_t>(row + x_high + 1)], f);
      }
  }

 private:
  int cell(int axis, Real at) const {
    const Real k = (at - low_[axis]) * inverse_size_;
    return k > 0 ? static_cast<int>(std::min(k, static_cast<Real>(size_[axis] - 1))) : 0;
  }

  template <class F>
  void row_of_cells(int i, const Real* place, Real reach, int from, int to, F&& f) const {
    for (int k = from; k < to; k += lane_count) {
      const auto at = [&](const Aligned<Real>& values) {
        Lanes lanes;
        __builtin_memcpy(&lanes, values.data() + k, sizeof lanes);
        return lanes;
      };
      const Lanes x = at(x_) - place[0], y = at(y_) - place[1], z = at(z_) - place[2], r = at(reach_) + reach;
      const Lanes excess = x * x + y * y + z * z - r * r;
#if defined(__AVX__) && defined(CYLON_ENGINE_FLOAT)
      unsigned bits = static_cast<unsigned>(_mm256_movemask_ps(excess));
#elif defined(__AVX__)
      unsigned bits = static_cast<unsigned>(_mm256_movemask_pd(excess));
#else
      unsigned bits = 0;
      for (int lane = 0; lane < lane_count; ++lane) bits |= static_cast<unsigned>(excess[lane] < 0) << lane;
#endif
      bits &= to - k < lane_count ? (1u << (to - k)) - 1 : ~0u;
      for (; bits != 0; bits &= bits - 1) {
        const int j = index_[static_cast<std::size_t>(k + __builtin_ctz(bits))];
        if (j > i) f(j);
      }
    }
  }

  Real low_[3] = {}, inverse_size_ = 1;
  int size_[3] = {1, 1, 1};
  std::vector<int> start_, cell_, index_;
  Aligned<Real> x_, y_, z_, reach_;
};

}  // namespace cylon::engine::pile
