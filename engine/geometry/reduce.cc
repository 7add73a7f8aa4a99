#include "engine/geometry/reduce.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {
namespace {

// cos and sin of k pi/8.
constexpr Real c1 = Real(0.92387953251128674), c2 = Real(0.70710678118654752), c3 = Real(0.38268343236508977);
constexpr std::array<std::array<Real, 2>, std::size_t{2}* Manifold::capacity> circle = {{{1, 0},
                                                                                         {c1, c3},
                                                                                         {c2, c2},
                                                                                         {c3, c1},
                                                                                         {0, 1},
                                                                                         {-c3, c1},
                                                                                         {-c2, c2},
                                                                                         {-c1, c3},
                                                                                         {-1, 0},
                                                                                         {-c1, -c3},
                                                                                         {-c2, -c2},
                                                                                         {-c3, -c1},
                                                                                         {0, -1},
                                                                                         {c3, -c1},
                                                                                         {c2, -c2},
                                                                                         {c1, -c3}}};

}  // namespace

Reduction::Reduction(const Vector3& normal, const Vector3& first) : first_(first) {
  all_.normal = normal, all_.count = 0;
}

void Reduction::add(const ContactPoint& point) {
  const auto offer = [&](const ContactPoint& p, int order) {
    for (std::size_t k = 0; k < looks; ++k) {
      const Real value = directions_[k].dot(p.position - all_.points[0].position);
      reach_[k] = std::max(reach_[k], value);  // the first point's is 0
      Held& best = best_[k / 2];
      if (k % 2 == 0 && (best.order < 0 || value > best.rank)) best = {p, order, value};
    }
    if (deepest_.order < 0 || -p.gap > deepest_.rank) deepest_ = {p, order, -p.gap};
  };
  if (seen_ < slots) {
    all_.points[static_cast<std::size_t>(all_.count++)] = point;
  } else {
    if (seen_ == slots) {
      const Vector3 x = (first_ - all_.normal.dot(first_) * all_.normal).normalized(),
                    y = all_.normal.cross(x);
      for (std::size_t k = 0; k < directions_.size(); ++k)
        directions_[k] = circle[k][0] * x + circle[k][1] * y;
      for (int k = 0; k < slots; ++k) offer(all_.points[static_cast<std::size_t>(k)], k);
    }
    offer(point, seen_);
  }
  ++seen_;
}

Manifold Reduction::result(Real spare) const {
  if (seen_ <= slots) return all_;
  // In the order in which they came, each once: one point may be outermost in several directions.
  std::array<Held, slots> held;
  std::size_t count = 0;
  const auto insert = [&](const Held& h) {
    std::size_t k = 0;
    while (k < count && held[k].order < h.order) ++k;
    if (k < count && held[k].order == h.order) return;
    for (std::size_t i = count++; i > k; --i) held[i] = held[i - 1];
    held[k] = h;
  };
  for (const Held& h : best_) insert(h);
  std::size_t nearest = 0;
  Real least = std::numeric_limits<Real>::infinity(), deepest = least, size = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Real distance = (held[k].point.position - deepest_.point.position).norm();
    if (distance < least) least = distance, nearest = k;
    deepest = std::min(deepest, held[k].point.gap), size = std::max(size, distance);
  }
  if (deepest_.point.gap < deepest - 64 * epsilon * size) {
    if (count == slots) {
      for (std::size_t k = nearest + 1; k < count; ++k) held[k - 1] = held[k];
      --count;
    }
    insert(deepest_);
  }
  Manifold result;
  result.normal = all_.normal;
  std::array<Real, looks> kept;
  kept.fill(std::numeric_limits<Real>::lowest());
  for (std::size_t i = 0; i < count; ++i) {
    result.points[static_cast<std::size_t>(result.count++)] = held[i].point;
    for (std::size_t k = 0; k < looks; ++k)
      kept[k] = std::max(kept[k], directions_[k].dot(held[i].point.position - all_.points[0].position));
  }
  for (std::size_t k = 0; k < looks; ++k)
    result.thinned = result.thinned || reach_[k] - kept[k] > spare + 64 * epsilon * size;
  return result;
}

Vector3 skew_direction(const Vector3& normal) {
  const Vector3 one(Real(0.36), Real(0.48), Real(0.8)), two(Real(0.48), Real(-0.8), Real(0.36));
  const Vector3& skew = std::abs(normal.dot(one)) < Real(0.9) ? one : two;
  return skew - normal.dot(skew) * normal;
}

Vector3 down_on_disc(const Vector3& normal) {
  const Real across = std::hypot(normal.x(), normal.z());
  return across > level_disc ? Vector3(-normal.x() / across, 0, -normal.z() / across)
                             : Vector3(Vector3::UnitX());
}

}  // namespace cylon::engine
