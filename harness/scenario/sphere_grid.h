// Spheres by place: one grid for each power of two of the radius, with cells of two such lengths, so that
// what may overlap a sphere of that size is in at most 27 cells of each grid.
#pragma once

#include "harness/core/scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace cylon::scenario {

class SphereGrid {
 public:
  /// A centre [m] that is finite, a radius >= 0 [m]; `id` is the caller's.
  void add(int id, const core::Vector3& centre, double radius) {
    const int level = level_of(radius);
    levels_.insert(level);
    const Cell cell = {level, index(centre.x(), level), index(centre.y(), level), index(centre.z(), level)};
    const auto [head, fresh] = heads_.try_emplace(cell, -1);
    balls_.push_back({id, centre, radius, std::exchange(head->second, static_cast<int>(balls_.size()))});
  }

  /// The least id for which `meets(id, centre, radius)`, among those that may overlap a sphere; -1: none.
  /// Adds to `looked_at` each cell and sphere that it looks at.
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
      if (!(cells <= static_cast<double>(heads_.size()) + 27) || !(farthest < countable)) {
        looked_at += heads_.size();
        for (const auto& [cell, head] : heads_)
          if (cell.level == level) look(head);
        continue;
      }
      looked_at += static_cast<std::size_t>(cells);
      for (double x = index(low.x(), level); x <= index(high.x(), level); ++x)
        for (double y = index(low.y(), level); y <= index(high.y(), level); ++y)
          for (double z = index(low.z(), level); z <= index(high.z(), level); ++z)
            if (const auto head = heads_.find({level, x, y, z}); head != heads_.end()) look(head->second);
    }
    return found;
  }

 private:
  struct Cell {
    int level;
    double x, y, z;  // whole numbers, which may be beyond an integer's range
    bool operator==(const Cell&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      auto h = static_cast<std::size_t>(c.level);
      for (const double v : {c.x, c.y, c.z}) h = (h ^ std::hash<double>()(v)) * 0x9e3779b97f4a7c15u;
      return h ^ (h >> 29);
    }
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

  std::set<int> levels_;
  std::vector<Ball> balls_;
  std::unordered_map<Cell, int, Hash> heads_;
};

}  // namespace cylon::scenario
