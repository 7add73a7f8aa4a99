// Which spheres are near which: a grid of cells whose outermost reach to infinity, and a list of the spheres
// that are too large for it.
#pragma once

#include "engine/ballistic/flight.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace cylon::engine::ballistic {

using Cell = std::array<int, 3>;

class Cells {
 public:
  /// Of the spheres that `collides` marks, at time t.  A cell holds about one of them, and is never smaller
  /// than the largest sphere in it, so that touching spheres are in neighbouring cells.
  void build(const std::vector<Flight>&, const std::vector<char>& collides, Time t);

  const Cell& cell(std::size_t body) const { return cells_[body]; }
  bool holds(std::size_t body) const { return held_[body] != 0; }
  const std::vector<std::size_t>& large() const { return large_; }

  bool divided() const { return count_ != Cell{1, 1, 1}; }

  /// Borders of the cells with index k along an axis [m].
  Real lower(std::size_t axis, int k) const { return k == 0 ? -infinity : border(axis, k); }
  Real upper(std::size_t axis, int k) const { return k + 1 == count_[axis] ? infinity : border(axis, k + 1); }

  /// Moves a body to the next cell along an axis; step is 1 or -1.
  void move(std::size_t body, std::size_t axis, int step) {
    unlink(body);
    cells_[body][axis] += step;
    link(body);
  }

  /// Calls use(other) for every sphere of the grid in the cells around `centre` whose index along `axis` is
  /// centre[axis] + from .. centre[axis] + to.
  template <class Use>
  void near(const Cell& centre, std::size_t axis, int from, int to, Use&& use) const {
    Cell low, high;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::max(0, centre[k] + (k == axis ? from : -1));
      high[k] = std::min(count_[k] - 1, centre[k] + (k == axis ? to : 1));
    }
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int z = low[2]; z <= high[2]; ++z)
          for (int i = heads_[index({x, y, z})]; i >= 0; i = next_[static_cast<std::size_t>(i)])
            use(static_cast<std::size_t>(i));
  }

  /// Whether a position lies outside the box that the inner cells cover, by more than a cell.
  bool outside(const Vector3& p) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Real x = p[static_cast<int>(k)];
      if (x < border(k, -1) || x > border(k, count_[k] + 1)) return true;
    }
    return false;
  }

 private:
  static constexpr Real infinity = std::numeric_limits<Real>::infinity();

  Real border(std::size_t axis, int k) const {
    return low_[static_cast<int>(axis)] + size_ * static_cast<Real>(k);
  }
  std::size_t index(const Cell& c) const {
    return static_cast<std::size_t>((std::ptrdiff_t{c[0]} * count_[1] + c[1]) * count_[2] + c[2]);
  }
  void link(std::size_t body);
  void unlink(std::size_t body);
  void choose_size(const std::vector<Flight>&, const std::vector<char>& collides, Time t);

  Vector3 low_ = Vector3::Zero();
  Real size_ = 1;
  Cell count_ = {1, 1, 1};
  std::vector<Cell> cells_;
  std::vector<char> held_;
  std::vector<int> heads_, next_, previous_;
  std::vector<std::size_t> large_;
};

}  // namespace cylon::engine::ballistic
