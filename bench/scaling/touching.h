// Which bodies of a crowd touch, and how deep they overlap, by geometry alone: no engine is asked.
#pragma once

#include "harness/core/convex.h"
#include "harness/core/scene.h"
#include "harness/core/solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cylon::bench {

struct Touching {
  std::int64_t pairs = 0;  ///< Closer than the skin, planes included.
  double deepest = 0;      ///< Overlap, >= 0 [m].
};

/// Of bodies of about one size: pairs are looked for in the 27 cells of a grid around each.  Requires finite positions.
inline Touching touching(const core::Scene& scene, const core::State& state, double skin) {
  std::vector<std::vector<core::Part>> parts;
  std::vector<double> bounds;
  for (const core::Body& body : scene.bodies)
    parts.push_back(core::convex_parts(body.shape)), bounds.push_back(core::bounding_radius(body.shape));
  const double cell_size = 2 * *std::max_element(bounds.begin(), bounds.end()) + skin;
  const auto placed = [&](std::size_t i, const core::Part& part) {
    return core::Placed{&part.shape, state[i].position + state[i].orientation * part.position,
                        state[i].orientation * part.orientation};
  };
  const auto separation = [&](std::size_t i, std::size_t j) {
    double least = (state[i].position - state[j].position).norm() - bounds[i] - bounds[j];
    if (least >= skin) return least;
    least = INFINITY;
    for (const core::Part& one : parts[i])
      for (const core::Part& other : parts[j])
        least = std::min(least, core::nearest(placed(i, one), placed(j, other)).gap);
    return least;
  };
  Touching result;
  const auto count = [&](double gap) {
    result.pairs += gap < skin;
    result.deepest = std::max(result.deepest, -gap);
  };
  using Cell = std::array<std::int64_t, 3>;
  std::vector<std::pair<Cell, std::size_t>> cells;
  for (std::size_t i = 0; i < state.size(); ++i) {
    for (const core::Plane& plane : scene.planes)
      count(plane.normal.dot(state[i].position) - plane.offset -
            core::support(scene.bodies[i].shape, state[i].orientation.conjugate() * -plane.normal));
    Cell cell;
    for (int k = 0; k < 3; ++k)
      cell[static_cast<std::size_t>(k)] =
          static_cast<std::int64_t>(std::floor(state[i].position[k] / cell_size));
    cells.emplace_back(cell, i);
  }
  std::sort(cells.begin(), cells.end());
  for (const auto& [cell, i] : cells)
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        // Three cells that follow each other in the order of the sort.
        const Cell low = {cell[0] + dx, cell[1] + dy, cell[2] - 1};
        const Cell high = {cell[0] + dx, cell[1] + dy, cell[2] + 1};
        for (auto it = std::lower_bound(cells.begin(), cells.end(), std::pair(low, std::size_t{0}));
             it != cells.end() && it->first <= high; ++it)
          if (it->second < i) count(separation(i, it->second));
      }
  return result;
}

}  // namespace cylon::bench
