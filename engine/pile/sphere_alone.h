// Contacts of spheres that nothing but each other could hold: both momenta stay to rounding, the energy
// falls.
//
// J acts on both bodies at the one point that divides d, from b's centre to a's, as the radii do, whether
// they touch there or not, and its normal part along d:  with e = d/|d| and q = |d|/(r_a + r_b)
//   u = v_a - v_b - q (s_a + s_b) x e,   s changes by -(r^2/I) q e x J
// so that d x J, what J adds to sum p x K, is what it takes from the spins.
#pragma once

#include "engine/pile/sphere_contact.h"

namespace cylon::engine::pile {

struct Line {
  Lanes length;  ///< [m]
  Lanes3 e;      ///< The contact's normal where the centres coincide.

  [[gnu::always_inline]] Line(const Lanes3& d, const Lanes3& otherwise) : length(root(dot(d, d))) {
    const auto apart = length > Lanes{};
    const Lanes inverse = 1 / (apart ? length : spread(1));
    e = {apart ? d.x * inverse : otherwise.x, apart ? d.y * inverse : otherwise.y,
         apart ? d.z * inverse : otherwise.z};
  }
};

/// From no impulse, which only ever takes energy away.  The gap is looked at along the contact's normal,
/// where they will touch; no more is given than ends their approach along the line of centres.
[[gnu::always_inline]] inline void solve_alone(const PairBatch& c, Real* velocities, const Real* places,
                                               Lanes inverse_h) {
  const Lanes zero{};
  Movers a, b;
  Places at, bt;
  a.load(velocities, c.a), b.load(velocities, c.b);
  at.load(places, c.a), bt.load(places, c.b);
  const Lanes reach = at.radius + bt.radius;
  const Lanes3 d = at.p - bt.p, v = a.v - b.v;
  const Line line(d, c.normal);
  const Lanes lever = reach > zero ? line.length / reach : zero;
  const Lanes gap = dot(c.normal, d) - reach;
  const Lanes needed = -(dot(c.normal, v) + larger(gap, zero) * inverse_h), toward = -dot(line.e, v);
  const Lanes normal = c.mass * larger(smaller(needed, toward), zero);

  const Lanes3 u = v - lever * cross(a.s + b.s, line.e);
  const Lanes3 stop = (-c.tangent_mass) * (u - dot(line.e, u) * line.e);
  const Lanes limit = c.friction * normal, length = root(dot(stop, stop));
  const Lanes3 t = (length > limit ? limit / length : spread(1)) * stop, j = normal * line.e + t;
  const Lanes3 turn = lever * cross(line.e, t);
  a.v = a.v + a.inverse_mass * j, a.s = a.s - a.inverse_inertia * turn;
  b.v = b.v - b.inverse_mass * j, b.s = b.s - b.inverse_inertia * turn;
  a.store(velocities, c.a), b.store(velocities, c.b);
}

/// Moves overlapping bodies apart as separate() does, along the line of centres as it is now; as the distance
/// grows the velocity across it gets less,  u_t' = u_t |d|/|d'|,  as on any body that moves out freely.
[[gnu::always_inline]] inline void separate_alone(const PairBatch& c, Real* velocities, Real* places,
                                                  Lanes share, Lanes slop) {
  const Lanes zero{};
  Movers a, b;
  Places at, bt;
  a.load(velocities, c.a), b.load(velocities, c.b);
  at.load(places, c.a), bt.load(places, c.b);
  const Lanes3 v = a.v - b.v;
  const Line line(at.p - bt.p, c.normal);
  const Lanes depth = at.radius + bt.radius - line.length - slop;
  const Lanes way = share * larger(depth, zero), farther = line.length + way;
  const Lanes3 shift = c.mass * way * line.e;
  const Lanes less = way > zero ? way / farther : zero;
  const Lanes3 j = (-(c.mass * less)) * (v - dot(v, line.e) * line.e);
  at.p = at.p + a.inverse_mass * shift, bt.p = bt.p - b.inverse_mass * shift;
  a.v = a.v + a.inverse_mass * j, b.v = b.v - b.inverse_mass * j;
  store(places, c.a, place_stride, at.p.x, at.p.y, at.p.z, at.radius);
  store(places, c.b, place_stride, bt.p.x, bt.p.y, bt.p.z, bt.radius);
  a.store(velocities, c.a), b.store(velocities, c.b);
}

// Without planes there are no such contacts.
inline void solve_alone(const PlaneBatch&, Real*, const Real*, Lanes) {}
inline void separate_alone(const PlaneBatch&, Real*, Real*, Lanes, Lanes) {}

}  // namespace cylon::engine::pile
