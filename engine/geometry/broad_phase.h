// Which of many bodies may touch: pairs whose axis-aligned bounds overlap.
#pragma once

#include "engine/geometry/pose.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace cylon::engine {

/// Bodies in the cells of grids of doubling cell size, each in the grid whose cells are just larger than it.
/// O(N log N) for bodies that do not crowd, whatever their sizes.  Keeps its memory between calls.
class BroadPhase {
 public:
  using Pair = std::pair<int, int>;

  /// All (i, j), i < j, whose bounds overlap or touch, in ascending order.  Empty bounds touch nothing;
  /// bounds that are not finite touch as they are.  Valid until the next call.
  const std::vector<Pair>& pairs(const std::vector<Bounds>&);

 private:
  struct Entry {
    std::uint64_t key = 0;  // level, z, y, x of the cell of the low corner
    int body = 0;
  };

  std::vector<Entry> entries_;
  std::vector<Bounds> sorted_;  // bounds in the order of the entries
  std::vector<int> unbounded_;
  std::vector<Pair> found_, pairs_;
  std::vector<int> starts_;
};

}  // namespace cylon::engine
