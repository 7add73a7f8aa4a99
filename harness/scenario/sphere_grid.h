// Spheres by place: one grid for each power of two of the radius, with cells of two such lengths, so that
// what may overlap a sphere of that size is in at most 27 cells of each grid.  Four cells in a row along x are
// one block of a hash table without lists, so that a look costs few misses of the processor's cache.
#pragma once

#include "harness/core/scene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
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
    const double x = index(centre.x(), level);
    const Key key = key_of(level, x, index(centre.y(), level), index(centre.z(), level));
    Block& block = blocks_[slot(key)];
    if (block.free()) ++used_;
    block.key = key;
    balls_.push_back(
        {id, centre, radius, std::exchange(block.heads[within(x)], static_cast<int>(balls_.size()))});
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
      const double from = index(low.x(), level), to = index(high.x(), level);
      for (double z = index(low.z(), level); z <= index(high.z(), level); ++z)
        for (double y = index(low.y(), level); y <= index(high.y(), level); ++y)
          for (double x = from; x <= to; x = 4 * std::floor(x / 4) + 4) {
            const Block& block = blocks_[slot(key_of(level, x, y, z), &looked_at)];
            if (block.free()) continue;
            for (std::size_t i = within(x); i < 4 && 4 * block.key.x + static_cast<double>(i) <= to; ++i)
              look(block.heads[i]);
            if (found == 0) return 0;
          }
    }
    return found;
  }

 private:
  struct Key {
    int level;
    double x, y, z;  // whole numbers, which may be beyond an integer's range; x counts blocks
    bool operator==(const Key&) const = default;
  };
  struct Block {
    static constexpr int nobody = std::numeric_limits<int>::min();  // no level of a double
    Key key = {nobody, 0, 0, 0};
    int heads[4] = {-1, -1, -1, -1};  // of the cells' lists
    bool free() const { return key.level == nobody; }
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
  static Key key_of(int level, double x, double y, double z) { return {level, std::floor(x / 4), y, z}; }
  static std::size_t within(double x) { return static_cast<std::size_t>(x - 4 * std::floor(x / 4)); }

  // Where a block is, or is to be: the first free place from that of its hash on, each added to `looked_at`.
  std::size_t slot(const Key& key, std::size_t* looked_at = nullptr) const {
    auto h = static_cast<std::uint64_t>(key.level);
    for (const double v : {key.x, key.y, key.z}) {
      // SplitMix64's mixing: small whole numbers differ in the highest bits of a double alone.
      h ^= std::bit_cast<std::uint64_t>(v);
      h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
      h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
      h ^= h >> 31;
    }
    const std::size_t mask = blocks_.size() - 1;
    std::size_t at = h & mask;
    for (;; at = (at + 1) & mask) {
      if (looked_at) ++*looked_at;
      if (blocks_[at].free() || blocks_[at].key == key) return at;
    }
  }
  void grow() {
    std::vector<Block> old =
        std::exchange(blocks_, std::vector<Block>(std::max<std::size_t>(64, 2 * blocks_.size())));
    for (const Block& block : old)
      if (!block.free()) blocks_[slot(block.key)] = block;
  }

  std::set<int> levels_;
  std::vector<Ball> balls_;
  std::vector<Block> blocks_;  // a power of two, at most half in use
  std::size_t used_ = 0;
};

}  // namespace cylon::scenario
