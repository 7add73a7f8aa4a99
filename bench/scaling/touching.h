// Which bodies of a crowd touch, and how deep they overlap, by geometry alone: no engine is asked.
#pragma once

#include "harness/core/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace cylon::bench {

struct Touching {
  std::int64_t pairs = 0;  ///< Closer than the skin, planes included.
  double deepest = 0;      ///< Overlap, >= 0 [m].
};

/// How far the shape reaches along the unit vector d of the world [m]: h(d) = max d . x.  Spheres and boxes.
inline double reach(const core::Body& body, const core::BodyState& state, const core::Vector3& d) {
  if (const auto* sphere = std::get_if<core::Sphere>(&body.shape)) return sphere->radius;
  return std::get<core::Box>(body.shape).half_extents.dot((state.orientation.conjugate() * d).cwiseAbs());
}

/// Spheres: the gap between them.  Boxes: the largest separation along their 15 axes (S. Gottschalk, M. Lin,
/// D. Manocha, OBBTree, SIGGRAPH 1996, section 5); below zero the overlap.  [m]
inline double separation(const core::Body& a, const core::BodyState& at_a, const core::Body& b,
                         const core::BodyState& at_b) {
  const core::Vector3 between = at_b.position - at_a.position;
  if (std::holds_alternative<core::Sphere>(a.shape)) {
    const core::Vector3 d = between.normalized();
    return between.norm() - reach(a, at_a, d) - reach(b, at_b, d);
  }
  const core::Matrix3 one = at_a.orientation.toRotationMatrix(), two = at_b.orientation.toRotationMatrix();
  double largest = -INFINITY;
  const auto along = [&](const core::Vector3& axis) {
    const double length = axis.norm();
    if (length < 1e-6) return;  // of two parallel edges: one of the faces decides
    const core::Vector3 d = axis / length;
    largest = std::max(largest, std::abs(between.dot(d)) - reach(a, at_a, d) - reach(b, at_b, d));
  };
  for (int i = 0; i < 3; ++i) {
    along(one.col(i)), along(two.col(i));
    for (int j = 0; j < 3; ++j) along(one.col(i).cross(two.col(j)));
  }
  return largest;
}

/// Bodies of one kind and size with bounding radius `bound` [m]: pairs are looked for in the 27 cells of a
/// grid around each.  Requires finite positions.
inline Touching touching(const core::Scene& scene, const core::State& state, double bound, double skin) {
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
            reach(scene.bodies[i], state[i], -plane.normal));
    Cell cell;
    for (int k = 0; k < 3; ++k)
      cell[static_cast<std::size_t>(k)] =
          static_cast<std::int64_t>(std::floor(state[i].position[k] / (2 * bound + skin)));
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
          if (it->second < i)
            count(separation(scene.bodies[i], state[i], scene.bodies[it->second], state[it->second]));
      }
  return result;
}

}  // namespace cylon::bench
