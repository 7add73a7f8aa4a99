#include "engine/contact/sharing.h"

#include "engine/contact/held_force.h"

#include <algorithm>

namespace cylon::engine {

namespace {

// Onto the cones of a part of the friction, point by point:  (f_n + m |f_t|)/(1 + m^2) times (1, m) on its edge, or its tip.
void pull_into_cones(const CoulombProblem& p, const std::vector<Hold>& hold, Real part, VectorX& f) {
  for (std::size_t i = 0; i < hold.size(); ++i) {
    const Real m = part * p.friction[i], size = f.segment<2>(first_row(i) + 1).norm();
    if (is_dry(p, i)) {
      if (size > part * p.bound[i]) f.segment<2>(first_row(i) + 1) *= part * p.bound[i] / size;
      continue;
    }
    if (hold[i].grip != Grip::sticks || size <= m * f[first_row(i)]) continue;
    const Real along = std::max<Real>(0, (f[first_row(i)] + m * size) / (1 + m * m));
    f[first_row(i)] = along;
    f.segment<2>(first_row(i) + 1) *= m * along / size;
  }
}

// The largest part of its friction that a point needs, and beyond all where one pulls, the more it does.  Along a line it falls,
// then rises.
Real largest_part(const CoulombProblem& p, const std::vector<Hold>& hold, const VectorX& f) {
  constexpr Real beyond = Real(1e9);
  Real largest = 0;
  for (std::size_t i = 0; i < hold.size(); ++i) {
    if (hold[i].grip == Grip::parts) continue;
    const Real normal = f[first_row(i)], edge = slip_edge(p, i, normal);
    if (normal < 0 || (hold[i].grip == Grip::sticks && !(edge > 0)))
      largest = std::max(largest, beyond * (1 - std::min(normal, edge)));
    else if (hold[i].grip == Grip::sticks)
      largest = std::max(largest, f.segment<2>(first_row(i) + 1).norm() / edge);
  }
  return largest;
}

// Where a function that falls, then rises, is least between two places, to 1e-4 of the way.
template <class Function>
Real lowest(Function&& f, Real low, Real high) {
  constexpr int thirds = 24;
  for (int i = 0; i < thirds; ++i) {
    const Real third = (high - low) / 3;
    if (f(low + third) > f(high - third))
      low += third;
    else
      high -= third;
  }
  return low;
}

// The way on which cones of a part of the friction pull a force, as far as the holds allow.
VectorX pull_of_cones(const CoulombProblem& p, const std::vector<Hold>& hold, Real part, const VectorX& f,
                      std::int64_t& operations) {
  VectorX pulled = f;
  pull_into_cones(p, hold, part, pulled);
  operations += linear_operations(3 * static_cast<std::int64_t>(p.friction.size()));
  return nearest_held_force(p, hold, pulled, nullptr) - f;
}

// From a force inside the cones inwards, for at their edge it would leave them as soon as something moves:  along the way on
// which narrower cones pull it, forth or back, to where it needs the least part of the friction, or this part.  Where one
// redundancy is left, as between two points that stick, that is the least of all.
VectorX moved_inwards(const CoulombProblem& p, const std::vector<Hold>& hold, VectorX f,
                      std::int64_t& operations) {
  constexpr int halvings = 10;
  constexpr Real enough = Real(0.9), longest = 4;
  for (const Real narrow : {Real(0.5), Real(0.8), Real(0.3)}) {  // of one part the pulls may cancel
    if (largest_part(p, hold, f) <= enough) break;
    const VectorX way = pull_of_cones(p, hold, narrow, f, operations);
    const auto part = [&](Real t) { return largest_part(p, hold, f + t * way); };
    Real inner = lowest(part, -longest, longest), outer = 0;
    if (!(part(inner) < part(0))) continue;
    for (int k = 0; k < halvings && part(inner) < enough; ++k) {
      const Real middle = (outer + inner) / 2;
      (part(middle) > enough ? outer : inner) = middle;
    }
    f += inner * way;
  }
  return f;
}

}  // namespace

bool share_within_cones(const CoulombProblem& p, const std::vector<Hold>& hold, const VectorX& from,
                        VectorX& shared, std::int64_t& operations) {
  constexpr int most_turns = 12;
  constexpr Real inner = Real(0.999);  // of the cones, so that the end is inside
  constexpr Real longest = 128;        // in steps of as much as the cones pull
  bool unique = false;
  operations += linear_operations(3 * static_cast<std::int64_t>(p.friction.size()));
  VectorX f = nearest_held_force(p, hold, from, &unique);
  for (int turn = 0; turn < most_turns && f.allFinite(); ++turn) {
    if (obeys(p, hold, f)) {
      shared = unique ? f : moved_inwards(p, hold, f, operations);
      if (!obeys(p, hold, shared)) shared = f;
      return true;
    }
    if (unique) return false;
    const VectorX way = pull_of_cones(p, hold, inner, f, operations);
    const auto distance = [&](Real t) {
      const VectorX at = f + t * way;
      VectorX pulled = at;
      pull_into_cones(p, hold, inner, pulled);
      return (pulled - at).squaredNorm();
    };
    f += lowest(distance, 0, longest) * way;
  }
  return false;
}

}  // namespace cylon::engine
