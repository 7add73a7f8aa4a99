// The spheres of a pile as rows of numbers, in an order that follows space.
#pragma once

#include "engine/model.h"
#include "engine/pile/sphere_contact.h"

#include <tbb/cache_aligned_allocator.h>

#include <vector>

namespace cylon::engine::pile {

template <class T>
using Aligned = std::vector<T, tbb::cache_aligned_allocator<T>>;

struct Spheres {
  int count = 0;
  Aligned<Real> velocity;     ///< (v, 1/m, r w, r^2/I), and `spare` rows of zeros for empty lanes.
  Aligned<Real> before;       ///< The velocities at the start of the part of the step, the same rows.
  Aligned<Real> kick;         ///< What the forces add to a velocity row, per second.
  Aligned<Real> place;        ///< (p, r)
  Aligned<Real> orientation;  ///< (w, x, y, z)
  std::vector<Real> inverse_radius;
  std::vector<Vector3> free_spin;  ///< Angular velocity of points, which nothing turns [rad/s].
  std::vector<int> surface;
  std::vector<Filter> filter;  ///< Empty: all touch.
  std::vector<int> id;         ///< Index in the model.

  Spheres(const Model&, int spare);

  void read(const std::vector<Body>&, std::vector<Motion>&) const;

  /// Row k becomes what row order[k] was.
  void reorder(const std::vector<int>& order);

  Real* v(int i) { return velocity.data() + velocity_stride * i; }
  const Real* v(int i) const { return velocity.data() + velocity_stride * i; }
  /// What the forces add to a velocity row, per second.
  const Real* g(int i) const { return kick.data() + velocity_stride * i; }
  /// Angular velocity [rad/s].
  Vector3 spin(int i) const {
    const auto k = static_cast<std::size_t>(i);
    return Eigen::Map<const Vector3>(v(i) + 4) * inverse_radius[k] + free_spin[k];
  }
  Real* p(int i) { return place.data() + place_stride * i; }
  const Real* p(int i) const { return place.data() + place_stride * i; }
};

/// Whether all bodies are balls or points whose inertia is the same about all axes, free of joints, under
/// gravity alone.
bool only_spheres(const Model&);

/// The rows in the order of a space-filling curve (Z order of cells of the given size).
std::vector<int> order_in_space(const Spheres&, Real cell);

}  // namespace cylon::engine::pile
