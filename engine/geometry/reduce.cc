#include "engine/geometry/reduce.h"

#include <algorithm>

namespace cylon::engine {
namespace {

// cos and sin of k 2 pi/7, to any precision that counts for choosing points.
constexpr std::array<std::array<Real, 2>, 7> circle = {
    {{Real(1), Real(0)},
     {Real(0.62348980185873353), Real(0.78183148246802981)},
     {Real(-0.22252093395631440), Real(0.97492791218182361)},
     {Real(-0.90096886790241913), Real(0.43388373911755812)},
     {Real(-0.90096886790241913), Real(-0.43388373911755812)},
     {Real(-0.22252093395631440), Real(-0.97492791218182361)},
     {Real(0.62348980185873353), Real(-0.78183148246802981)}}};

}  // namespace

Reduction::Reduction(const Vector3& normal) { all_.normal = normal, all_.count = 0; }

void Reduction::add(const ContactPoint& point) {
  const auto rank = [&](std::size_t slot, const ContactPoint& p) {
    return slot + 1 < slots ? directions_[slot].dot(p.position) : -p.gap;
  };
  const auto offer = [&](const ContactPoint& p, int order) {
    for (std::size_t slot = 0; slot < slots; ++slot) {
      const Real value = rank(slot, p);
      if (best_[slot].order < 0 || value > best_[slot].rank) best_[slot] = {p, order, value};
    }
  };
  if (seen_ < slots) {
    all_.points[static_cast<std::size_t>(all_.count++)] = point;
  } else {
    if (seen_ == slots) {
      int least = 0;
      all_.normal.cwiseAbs().minCoeff(&least);
      const Vector3 x = all_.normal.cross(Vector3::Unit(least)).normalized(), y = all_.normal.cross(x);
      for (std::size_t k = 0; k < directions_.size(); ++k)
        directions_[k] = circle[k][0] * x + circle[k][1] * y;
      for (int k = 0; k < slots; ++k) offer(all_.points[static_cast<std::size_t>(k)], k);
    }
    offer(point, seen_);
  }
  ++seen_;
}

Manifold Reduction::result() const {
  if (seen_ <= slots) return all_;
  std::array<Held, slots> held = best_;
  std::sort(held.begin(), held.end(), [](const Held& a, const Held& b) { return a.order < b.order; });
  Manifold result;
  result.normal = all_.normal;
  result.thinned = true;
  for (std::size_t k = 0; k < held.size(); ++k)
    if (k == 0 || held[k].order != held[k - 1].order)
      result.points[static_cast<std::size_t>(result.count++)] = held[k].point;
  return result;
}

}  // namespace cylon::engine
