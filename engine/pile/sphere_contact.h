// Contacts of spheres with spheres and planes, some at once: one for each lane, no body twice.
//
// A sphere of radius r is a row (v, 1/m, s, r^2/I) with s = r w, and a row (p, r).  At a contact with normal
// n from b to a the surfaces move against each other with
//   u = v_a - v_b - (s_a + s_b) x n
// and an impulse J on a changes  v_a by J/m_a,  s_a by -(r_a^2/I_a) n x J,  v_b by -J/m_b,  s_b by
// -(r_b^2/I_b) n x J.  So the tangential mass 1/(1/m_a + 1/m_b + r_a^2/I_a + r_b^2/I_b) is the same in all
// directions, and friction is a vector that is shortened to the cone, without tangents.
#pragma once

#include "engine/pile/lanes.h"

namespace cylon::engine::pile {

inline constexpr std::ptrdiff_t velocity_stride = 8, place_stride = 4;

struct PairBatch {
  static constexpr bool plane = false;
  Lanes3 normal;
  Lanes mass, tangent_mass, friction;
  Lanes impulse;      ///< Along the normal, of one part of the step [N s].
  Lanes3 tangential;  ///< [N s]
  int a[lane_count], b[lane_count];
  int pair[lane_count];  ///< Row where its impulses are kept for the next step.
  int old[lane_count];   ///< Row where those of the step before are; 0: none.
};

struct PlaneBatch {
  static constexpr bool plane = true;
  Lanes3 normal;
  Lanes offset;  ///< Of the plane [m].
  Lanes mass, tangent_mass, friction;
  Lanes impulse;
  Lanes3 tangential;
  int a[lane_count], b[lane_count];  ///< b: index of the plane.
  int pair[lane_count];
  int old[lane_count];
};

/// One body a lane.
struct Movers {
  Lanes3 v;
  Lanes inverse_mass;
  Lanes3 s;
  Lanes inverse_inertia;

  [[gnu::always_inline]] void load(const Real* rows, const int* row) {
    pile::load(rows, row, velocity_stride, v.x, v.y, v.z, inverse_mass);
    pile::load(rows + 4, row, velocity_stride, s.x, s.y, s.z, inverse_inertia);
  }
  [[gnu::always_inline]] void store(Real* rows, const int* row) const {
    pile::store(rows, row, velocity_stride, v.x, v.y, v.z, inverse_mass);
    pile::store(rows + 4, row, velocity_stride, s.x, s.y, s.z, inverse_inertia);
  }
};

struct Places {
  Lanes3 p;
  Lanes radius;

  [[gnu::always_inline]] void load(const Real* rows, const int* row) {
    pile::load(rows, row, place_stride, p.x, p.y, p.z, radius);
  }
};

/// The impulse that ends the approach: normal part >= 0, tangential part within the cone |J_t| <= friction
/// J_n.
///   u_n >= -max(gap, 0)/h: a gap may close within the part of the step, h, but not more.
template <class Batch>
[[gnu::always_inline]] inline Lanes3 impulse_change(Batch& c, const Lanes3& u, Lanes gap, Lanes inverse_h) {
  const Lanes zero{};
  const Lanes u_n = dot(c.normal, u);
  const Lanes normal = larger(c.impulse - c.mass * (u_n + larger(gap, zero) * inverse_h), zero);
  const Lanes change = normal - c.impulse;
  c.impulse = normal;

  Lanes3 t = c.tangential - c.tangent_mass * (u - u_n * c.normal);
  const Lanes limit = c.friction * normal, length = root(dot(t, t));
  t = (length > limit ? limit / length : spread(1)) * t;
  const Lanes3 result = change * c.normal + (t - c.tangential);
  c.tangential = t;
  return result;
}

[[gnu::always_inline]] inline void push(Movers& a, Movers& b, const Lanes3& n, const Lanes3& j) {
  const Lanes3 turn = cross(n, j);
  a.v = a.v + a.inverse_mass * j, a.s = a.s - a.inverse_inertia * turn;
  b.v = b.v - b.inverse_mass * j, b.s = b.s - b.inverse_inertia * turn;
}

[[gnu::always_inline]] inline void push(Movers& a, const Lanes3& n, const Lanes3& j) {
  a.v = a.v + a.inverse_mass * j, a.s = a.s - a.inverse_inertia * cross(n, j);
}

[[gnu::always_inline]] inline void warm_start(const PairBatch& c, Real* velocities) {
  Movers a, b;
  a.load(velocities, c.a), b.load(velocities, c.b);
  push(a, b, c.normal, c.impulse * c.normal + c.tangential);
  a.store(velocities, c.a), b.store(velocities, c.b);
}

[[gnu::always_inline]] inline void warm_start(const PlaneBatch& c, Real* velocities) {
  Movers a;
  a.load(velocities, c.a);
  push(a, c.normal, c.impulse * c.normal + c.tangential);
  a.store(velocities, c.a);
}

[[gnu::always_inline]] inline void solve(PairBatch& c, Real* velocities, const Real* places,
                                         Lanes inverse_h) {
  Movers a, b;
  Places at, bt;
  a.load(velocities, c.a), b.load(velocities, c.b);
  at.load(places, c.a), bt.load(places, c.b);
  const Lanes gap = dot(c.normal, at.p - bt.p) - (at.radius + bt.radius);
  const Lanes3 u = a.v - b.v - cross(a.s + b.s, c.normal);
  push(a, b, c.normal, impulse_change(c, u, gap, inverse_h));
  a.store(velocities, c.a), b.store(velocities, c.b);
}

[[gnu::always_inline]] inline void solve(PlaneBatch& c, Real* velocities, const Real* places,
                                         Lanes inverse_h) {
  Movers a;
  Places at;
  a.load(velocities, c.a), at.load(places, c.a);
  const Lanes gap = dot(c.normal, at.p) - c.offset - at.radius;
  const Lanes3 u = a.v - cross(a.s, c.normal);
  push(a, c.normal, impulse_change(c, u, gap, inverse_h));
  a.store(velocities, c.a);
}

/// By how much solve() would change the velocity of each contact [m/s].
[[gnu::always_inline]] inline Lanes unmet_of(const Lanes3& change, const Lanes3& n, Lanes mass,
                                             Lanes tangent_mass) {
  const Lanes zero{}, along = dot(n, change);
  const Lanes3 across = change - along * n;
  const Lanes normal = mass > zero ? along / mass : zero;
  const Lanes slip = tangent_mass > zero ? root(dot(across, across)) / tangent_mass : zero;
  return root(normal * normal + slip * slip);
}

/// Of the last part of a step, after the bodies have moved: `gap` is that before.
[[gnu::always_inline]] inline Lanes unmet(const PairBatch& batch, const Real* velocities, const Real* places,
                                          Lanes inverse_h) {
  PairBatch c = batch;
  Movers a, b;
  Places at, bt;
  a.load(velocities, c.a), b.load(velocities, c.b);
  at.load(places, c.a), bt.load(places, c.b);
  const Lanes gap =
      dot(c.normal, at.p - bt.p) - (at.radius + bt.radius) - dot(c.normal, a.v - b.v) / inverse_h;
  const Lanes3 u = a.v - b.v - cross(a.s + b.s, c.normal);
  return unmet_of(impulse_change(c, u, gap, inverse_h), c.normal, c.mass, c.tangent_mass);
}

[[gnu::always_inline]] inline Lanes unmet(const PlaneBatch& batch, const Real* velocities, const Real* places,
                                          Lanes inverse_h) {
  PlaneBatch c = batch;
  Movers a;
  Places at;
  a.load(velocities, c.a), at.load(places, c.a);
  const Lanes gap = dot(c.normal, at.p) - c.offset - at.radius - dot(c.normal, a.v) / inverse_h;
  const Lanes3 u = a.v - cross(a.s, c.normal);
  return unmet_of(impulse_change(c, u, gap, inverse_h), c.normal, c.mass, c.tangent_mass);
}

/// Moves overlapping bodies apart by a share of what exceeds `slop`, the lighter one farther; the common
/// centre of mass stays, velocities too.
[[gnu::always_inline]] inline void separate(const PairBatch& c, const Real* velocities, Real* places,
                                            Lanes share, Lanes slop) {
  Movers a, b;
  Places at, bt;
  at.load(places, c.a), bt.load(places, c.b);
  Lanes unused;
  pile::load(velocities, c.a, velocity_stride, unused, unused, unused, a.inverse_mass);
  pile::load(velocities, c.b, velocity_stride, unused, unused, unused, b.inverse_mass);
  const Lanes depth = at.radius + bt.radius - dot(c.normal, at.p - bt.p) - slop;
  const Lanes3 shift = share * c.mass * larger(depth, Lanes{}) * c.normal;
  at.p = at.p + a.inverse_mass * shift, bt.p = bt.p - b.inverse_mass * shift;
  store(places, c.a, place_stride, at.p.x, at.p.y, at.p.z, at.radius);
  store(places, c.b, place_stride, bt.p.x, bt.p.y, bt.p.z, bt.radius);
}

[[gnu::always_inline]] inline void separate(const PlaneBatch& c, const Real*, Real* places, Lanes share,
                                            Lanes slop) {
  Places at;
  at.load(places, c.a);
  const Lanes depth = at.radius + c.offset - dot(c.normal, at.p) - slop;
  const Lanes held = c.mass > Lanes{} ? share : Lanes{};
  at.p = at.p + held * larger(depth, Lanes{}) * c.normal;
  store(places, c.a, place_stride, at.p.x, at.p.y, at.p.z, at.radius);
}

}  // namespace cylon::engine::pile
