// Spheres by place: one grid for each power of two of the radius, with cells of two such lengths, so that
// what may overlap a sphere of that size is in at most 27 cells of each grid.  4 x 2 x 2 cells are one block of a
// hash table without lists, so that a look costs few misses of the processor's cache.
#pragma once

#include "harness/core/scene.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace cylon::scenario {

class SphereGrid {
 public:
  /// A centre [m] that is finite, a radius >= 0 [m]; `id` is the caller's.
  void add(int id, const core::Vector3& centre, double radius) {
    const int level = level_of(radius);
    levels_.insert(level);
    if (2 * (used_ + 1) > blocks_.size()) grow();
    const Cell cell = {index(centre.x(), level), index(centre.y(), level), index(centre.z(), level)};
    const Key key = key_of(level, cell);
    Block& block = blocks_[slot(key, home(key))];
    if (block.free()) ++used_;
    block.key = key;
    balls_.push_back(
        {id, centre, radius, std::exchange(block.heads[within(cell)], static_cast<int>(balls_.size()))});
  }

  /// The least id for which `meets(id, centre, radius)`, among those that may overlap a sphere; -1: none.
  /// Adds to `looked_at` each block and sphere that it looks at.
  template <class Meets>
  int first(const core::Vector3& at, double radius, std::size_t& looked_at, const Meets& meets) const {
    int found = -1;
    const auto look = [&](int head) {
      for (int i = head; i >= 0; i = balls_[static_cast<std::size_t>(i)].next) {
        const Ball& ball = balls_[static_cast<std::size_t>(i)];
        ++looked_at;
        if ((found < 0 || ball.id < found) && meets(ball.id, ball.centre, ball.radius)) found = ball.id;
      }
    };
    for (const int level : levels_) {
      const double reach = radius + std::ldexp(1.0, level);  // no sphere of the level is larger
      const core::Vector3 low = at - core::Vector3::Constant(reach),
                          high = at + core::Vector3::Constant(reach);
      double cells = 1, farthest = 0;
      for (int i = 0; i < 3; ++i) {
        const double from = index(low[i], level), to = index(high[i], level);
        cells *= to - from + 1;
        farthest = std::max({farthest, std::abs(from), std::abs(to)});
      }
      // A large sphere over a fine grid: fewer cells are in use than it covers.  Or one so far out that
      // doubles do not count the cells there.
      constexpr double countable = 4503599627370496;  // 2^52
      if (!(cells <= static_cast<double>(blocks_.size()) + 27) || !(farthest < countable)) {
        looked_at += blocks_.size();
        for (const Block& block : blocks_)
          if (!block.free() && block.key.level == level)
            for (const int head : block.heads) look(head);
        continue;
      }
      const Cell from = {index(low.x(), level), index(low.y(), level), index(low.z(), level)},
                 to = {index(high.x(), level), index(high.y(), level), index(high.z(), level)};
      // A look at a place of the table waits for memory: many are asked for before the first is needed.
      std::array<Place, 32> batch;
      std::size_t waiting = 0;
      const auto look_at_batch = [&] {
        const std::span<Place> asked(batch.data(), std::exchange(waiting, 0));
        for (Place& place : asked) {
          place.at = slot(place.key, place.at, &place.probes);
          each_cell(place.key, from, to, [&](std::size_t cell) {
            if (const int head = blocks_[place.at].heads[cell]; head >= 0)
              __builtin_prefetch(&balls_[static_cast<std::size_t>(head)]);
          });
        }
        for (const Place& place : asked) {
          if (found == 0) return;
          looked_at += place.probes;
          const Block& block = blocks_[place.at];
          if (!block.free())
            each_cell(place.key, from, to, [&](std::size_t cell) { look(block.heads[cell]); });
        }
      };
      const Key first = key_of(level, from), last = key_of(level, to);
      for (double z = first.z; z <= last.z; ++z)
        for (double y = first.y; y <= last.y; ++y)
          for (double x = first.x; x <= last.x; ++x) {
            const Key key = {level, x, y, z};
            batch[waiting] = {key, home(key)};
            __builtin_prefetch(&blocks_[batch[waiting].at]);
            if (++waiting == batch.size()) look_at_batch();
            if (found == 0) return 0;  // what is looked at counts, and nothing else is done
          }
      look_at_batch();
      if (found == 0) return 0;
    }
    return found;
  }

 private:
  // Whole numbers, which may be beyond an integer's range.
  struct Cell {
    double x, y, z;
  };
  struct Key {
    int level;
    double x, y, z;  // count blocks
    bool operator==(const Key&) const = default;
  };
  static constexpr int in_x = 4, in_y = 2, in_z = 2;  // cells of a block
  struct Block {
    static constexpr int nobody = std::numeric_limits<int>::min();  // no level of a double
    Block() { heads.fill(-1); }
    Key key = {nobody, 0, 0, 0};
    std::array<int, std::size_t{in_x} * in_y * in_z> heads;  // of the cells' lists; -1: empty
    bool free() const { return key.level == nobody; }
  };
  struct Place {
    Key key;
    std::size_t at;  // in blocks_
    std::size_t probes = 0;
  };
  struct Ball {
    int id;
    core::Vector3 centre;
    double radius;
    int next;  // in its cell; -1: the last
  };

  static int level_of(double radius) {
    int exponent = 0;
    std::frexp(radius, &exponent);  // radius < 2^exponent
    return exponent;
  }
  static double index(double x, int level) { return std::floor(std::ldexp(x, -level - 1)) + 0.0; }
  static Key key_of(int level, const Cell& c) {
    return {level, std::floor(c.x / in_x), std::floor(c.y / in_y), std::floor(c.z / in_z)};
  }
  // Of a cell in its block, from its place there.
  static std::size_t within(int x, int y, int z) {
    const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y),
               k = static_cast<std::size_t>(z);
    return i + in_x * (j + in_y * k);
  }
  static std::size_t within(const Cell& c) {
    const Key key = key_of(0, c);
    const auto place = [](double cell, double block, int n) { return static_cast<int>(cell - n * block); };
    return within(place(c.x, key.x, in_x), place(c.y, key.y, in_y), place(c.z, key.z, in_z));
  }
  // Calls visit(cell) for each cell of a block from one corner of a box to the other.
  template <class Visit>
  static void each_cell(const Key& block, const Cell& from, const Cell& to, const Visit& visit) {
    const auto low = [](double f, double b, int n) { return static_cast<int>(std::max(f - n * b, 0.0)); };
    const auto top = [](double t, double b, int n) { return static_cast<int>(std::min(t - n * b, n - 1.0)); };
    const int x0 = low(from.x, block.x, in_x), x1 = top(to.x, block.x, in_x), y0 = low(from.y, block.y, in_y),
              y1 = top(to.y, block.y, in_y), z0 = low(from.z, block.z, in_z), z1 = top(to.z, block.z, in_z);
    for (int z = z0; z <= z1; ++z)
      for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) visit(within(x, y, z));
  }

  // Where the search for a block begins.
  std::size_t home(const Key& key) const {
    auto h = static_cast<std::uint64_t>(key.level);
    for (const double v : {key.x, key.y, key.z}) {
      // SplitMix64's mixing: small whole numbers differ in the highest bits of a double alone.
      h ^= std::bit_cast<std::uint64_t>(v);
      h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
      h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
      h ^= h >> 31;
    }
    return h & (blocks_.size() - 1);
  }
  // Where a block is, or is to be: the first free place from `at`, its home, on, each added to `probes`.
  std::size_t slot(const Key& key, std::size_t at, std::size_t* probes = nullptr) const {
    for (;; at = (at + 1) & (blocks_.size() - 1)) {
      if (probes) ++*probes;
      if (blocks_[at].free() || blocks_[at].key == key) return at;
    }
  }
  void grow() {
    std::vector<Block> old =
        std::exchange(blocks_, std::vector<Block>(std::max<std::size_t>(64, 2 * blocks_.size())));
    for (const Block& block : old)
      if (!block.free()) blocks_[slot(block.key, home(block.key))] = block;
  }

  std::set<int> levels_;
  std::vector<Ball> balls_;
  std::vector<Block> blocks_;  // a power of two, at most half in use
  std::size_t used_ = 0;
};

}  // namespace cylon::scenario
