// Which spheres are near which: a grid of cells whose outermost reach to infinity, and a list of the spheres
// that are too large for it.
#pragma once

#include "engine/ballistic/flight.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
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

  /// Moves a body to the next cell along an axis; step is 1 or -1.  Where cells are crowded beyond measure it
  /// joins the large ones, which its holds() then tells.
  void move(std::size_t body, std::size_t axis, int step) {
    take_out(body);
    cells_[body][axis] += step;
    put(body);
  }

  /// Every sphere of the grid in the cells around `centre` whose index along `axis` is centre[axis] + from ..
  /// centre[axis] + to.  Valid until the next call.
  std::span<const int> near(const Cell& centre, std::size_t axis, int from, int to) {
    Cell low, high;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::max(0, centre[k] + (k == axis ? from : -1));
      high[k] = std::min(count_[k] - 1, centre[k] + (k == axis ? to : 1));
    }
    std::size_t n = 0;
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int z = low[2]; z <= high[2]; ++z) {
          const std::size_t cell = index({x, y, z});
          // all slots, used or not: how many are used is nothing that a branch could guess
          for (std::size_t i = 0; i < width_; i += least_width)
            std::copy_n(slots_.data() + cell * width_ + i, least_width, found_.data() + n + i);
          n += counts_[cell];
        }
    return {found_.data(), n};
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
  static constexpr std::size_t least_width = 4;

  Real border(std::size_t axis, int k) const {
    return low_[static_cast<int>(axis)] + size_ * static_cast<Real>(k);
  }
  std::size_t index(const Cell& c) const {
    return static_cast<std::size_t>((std::ptrdiff_t{c[0]} * count_[1] + c[1]) * count_[2] + c[2]);
  }
  void put(std::size_t body);
  void take_out(std::size_t body);
  bool widen();
  void choose_size(const std::vector<Flight>&, const std::vector<char>& collides, Time t);

  Vector3 low_ = Vector3::Zero();
  Real size_ = 1;
  Cell count_ = {1, 1, 1};
  std::vector<Cell> cells_;
  std::vector<char> held_;
  std::size_t width_ = least_width;  // slots of a cell
  std::vector<std::size_t> counts_;  // how many are used, the first ones
  std::vector<int> slots_;           // width_ for each cell: bodies
  std::vector<std::size_t> places_;  // of each body: its slot
  std::vector<int> found_;
  std::vector<std::size_t> large_;
};

}  // namespace cylon::engine::ballistic
