#include "engine/geometry/triangle_hull.h"

#include "engine/geometry/orient.h"

#include <algorithm>
#include <utility>

namespace cylon::engine {

std::vector<std::array<int, 3>> triangle_hull(const std::vector<Eigen::Vector3d>& points,
                                              const std::array<int, 4>& first) {
  const auto at = [&](int i) -> const Eigen::Vector3d& { return points[static_cast<std::size_t>(i)]; };
  auto [a, b, c, d] = first;
  if (side_of_plane(at(a), at(b), at(c), at(d)) > 0) std::swap(b, c);
  std::vector<std::array<int, 3>> triangles = {{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}}, hidden;
  std::vector<std::pair<int, int>> border;

  for (int p = 0; p < static_cast<int>(points.size()); ++p) {
    if (std::find(first.begin(), first.end(), p) != first.end()) continue;
    hidden.clear(), border.clear();
    for (const auto& t : triangles) {
      if (side_of_plane(at(t[0]), at(t[1]), at(t[2]), at(p)) <= 0) {
        hidden.push_back(t);
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) border.emplace_back(t[k], t[(k + 1) % 3]);
    }
    if (border.empty()) continue;
    std::sort(border.begin(), border.end());
    for (const auto& [from, to] : border)
      if (!std::binary_search(border.begin(), border.end(), std::pair(to, from)))
        hidden.push_back({from, to, p});
    triangles.swap(hidden);
  }
  return triangles;
}

}  // namespace cylon::engine
