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

  /// Writes every j > i that is near i to `found`, which must have room for most() of them; returns their
  /// number.  The order is that of the cells.
  int near(int i, const Real* place, Real reach, int* found) const {
    if (reach < 0) return 0;
    const int x = cell(0, place[0]), y = cell(1, place[1]), z = cell(2, place[2]);
    const int x_low = std::max(x - 1, 0), x_high = std::min(x + 1, size_[0] - 1);
    int n = 0;
    for (int k = std::max(z - 1, 0); k <= std::min(z + 1, size_[2] - 1); ++k)
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size_[1] - 1); ++j) {
        const int* row = start_.data() + (static_cast<std::ptrdiff_t>(k) * size_[1] + j) * size_[0];
        n += row_of_cells(i, place, reach, row[x_low], row[x_high + 1], found + n);
      }
    return n;
  }

  /// Room that near() may need: as it writes first and counts then, a little more than it finds.
  int most() const { return 27 * fullest_ + lane_count; }

 private:
  int cell(int axis, Real at) const {
    const Real k = (at - low_[axis]) * inverse_size_;
    return k > 0 ? static_cast<int>(std::min(k, static_cast<Real>(size_[axis] - 1))) : 0;
  }

  // Writes without branching: which of the candidates are near is anybody's guess.
  int row_of_cells(int i, const Real* place, Real reach, int from, int to, int* found) const {
    int n = 0;
    for (int k = from; k < to; k += lane_count) {
      const auto at = [&](const Aligned<Real>& values) {
        Lanes lanes;
        __builtin_memcpy(&lanes, values.data() + k, sizeof lanes);
        return lanes;
      };
      const Lanes x = at(x_) - place[0], y = at(y_) - place[1], z = at(z_) - place[2], r = at(reach_) + reach;
      const auto near = x * x + y * y + z * z < r * r;
      const int left = std::min(to - k, lane_count);
      n += take_later(signs(near) & ((1u << left) - 1), index_.data() + k, i, found + n);
    }
    return n;
  }

  Real low_[3] = {}, inverse_size_ = 1;
  int size_[3] = {1, 1, 1};
  int fullest_ = 0;  // bodies in the fullest cell
  std::vector<int> start_, cell_, index_;
  Aligned<Real> x_, y_, z_, reach_;
};

}  // namespace cylon::engine::pile
