#include "harness/core/near_pairs.h"

#include "harness/core/collision_filter.h"
#include "harness/core/surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace cylon::core {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct Entry {
  Cell cell;
  int body;
  friend bool operator<(const Entry& a, const Entry& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.body < b.body;
  }
};

// Monotone, so that what lies less than an edge apart is in neighbouring cells however far away it is.
Cell cell_of(const Vector3& place, double edge) {
  constexpr double farthest = 1e12;  // cells; the rounding of a quotient is then 1e-4 of a cell
  Cell cell;
  for (int c = 0; c < 3; ++c)
    cell[static_cast<std::size_t>(c)] =
        static_cast<std::int64_t>(std::floor(std::clamp(place[c] / edge, -farthest, farthest)));
  return cell;
}

struct Ball {
  int body;
  double radius;
};

// The bodies that collide, as balls; nothing where a grid does not serve.
std::optional<std::vector<Ball>> balls(const Scene& scene, const State& state) {
  std::vector<Ball> result;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!collides(scene.bodies[i])) continue;
    const auto radius = ball_radius(scene.bodies[i].shape);
    if (!radius || !state[i].position.allFinite()) return std::nullopt;
    result.push_back({static_cast<int>(i), *radius});
  }
  return result;
}

// Above this a ball is large: cells for it would hold too many others.
double large(const std::vector<Ball>& all) {
  std::vector<double> radii;
  for (const Ball& ball : all) radii.push_back(ball.radius);
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return 4 * *middle;
}

// Shows each pair of entries in the same or in neighbouring cells once: behind an entry in its own column of
// cells along z, and in the four columns that lie behind that.
template <class Show>
void for_each_neighbour(const std::vector<Entry>& sorted, Show show) {
  for (auto own = sorted.begin(); own != sorted.end(); ++own) {
    const auto [x, y, z] = own->cell;
    for (auto it = std::next(own); it != sorted.end() && it->cell <= Cell{x, y, z + 1}; ++it)
      show(own->body, it->body);
    for (const auto& [dx, dy] : {std::array{0, 1}, std::array{1, -1}, std::array{1, 0}, std::array{1, 1}})
      for (auto it = std::lower_bound(own, sorted.end(), Entry{{x + dx, y + dy, z - 1}, world});
           it != sorted.end() && it->cell <= Cell{x + dx, y + dy, z + 1}; ++it)
        show(own->body, it->body);
  }
}

}  // namespace

std::optional<double> ball_radius(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return sphere->radius;
  if (std::holds_alternative<std::monostate>(shape)) return 0.0;
  return std::nullopt;
}

std::vector<Pair> near_pairs(const Scene& scene, const State& state) {
  const auto all = balls(scene, state);
  if (!all || all->empty()) return touching_pairs(scene);
  std::vector<Pair> pairs;
  const ContactRules may_touch(scene);
  const auto add = [&](int a, int b) {
    if (may_touch.bodies(a, b)) pairs.push_back({std::min(a, b), std::max(a, b), -1});
  };
  const double limit = large(*all);
  double widest = 0;
  for (const Ball& ball : *all)
    if (ball.radius <= limit) widest = std::max(widest, ball.radius);
  const double edge = widest > 0 ? 2.02 * widest : 1;
  std::vector<Entry> small;
  for (const Ball& ball : *all) {
    if (ball.radius <= limit) {
      small.push_back({cell_of(state[static_cast<std::size_t>(ball.body)].position, edge), ball.body});
      continue;
    }
    for (const Ball& other : *all)
      if (other.radius <= limit || other.body > ball.body) add(ball.body, other.body);
  }
  std::sort(small.begin(), small.end());
  for_each_neighbour(small, add);
  for (const Ball& ball : *all)
    for (int p = 0; p < static_cast<int>(scene.planes.size()); ++p)
      if (may_touch.body_and_plane(ball.body, p)) pairs.push_back({ball.body, world, p});
  const auto place = [](const Pair& pair) { return std::array{pair.body, pair.plane, pair.other}; };
  std::sort(pairs.begin(), pairs.end(), [&](const Pair& a, const Pair& b) { return place(a) < place(b); });
  return pairs;
}

}  // namespace cylon::core
