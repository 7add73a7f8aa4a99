// When a moving sphere meets a plane or another sphere.
#pragma once

#include "engine/ballistic/flight.h"
#include "engine/ballistic/roots.h"
#include "engine/lanes.h"
#include "engine/shape.h"

namespace cylon::engine::ballistic {

/// Part of a sum that may be rounding: some operations of half an ulp each.
inline constexpr Real rounding = 8 * epsilon;

inline Real size(const Vector3& v) { return v.lpNorm<1>(); }

/// x, or 0 where it may be the rounding of zero.
inline Real rounded(Real x, Real scale) { return std::abs(x) <= rounding * scale ? Real(0) : x; }

/// Distance that separates touching from apart [m].  The rounding of n.p is that of its terms: a coordinate
/// along the plane, however large, has no part in it.
inline Real touching(const Flight& f, const Plane& plane) {
  const Real terms = plane.normal.cwiseAbs().dot(f.position.cwiseAbs());
  return rounding * (terms + std::abs(plane.offset) + f.radius);
}

/// gap = n.p - offset - r [m].
inline Real gap(const Flight& f, const Plane& plane) {
  return plane.normal.dot(f.position) - plane.offset - f.radius;
}

/// Time from f.since to the contact with a plane [s].
inline Real contact(const Flight& f, const Plane& plane) {
  Real distance = gap(f, plane);
  Real rate = plane.normal.dot(f.velocity), acceleration = plane.normal.dot(f.acceleration);
  acceleration = rounded(acceleration, size(f.acceleration));
  if (distance <= touching(f, plane)) {
    distance = 0;
    rate = rounded(rate, size(f.velocity));
  }
  return first_contact(distance, rate, acceleration);
}

/// Two spheres, one number or some pairs side by side, at an instant `base`.
template <class N>
struct Pair {
  Triple<N> d, w;  ///< Place and velocity of one from the other [m], [m/s].
  N c, b, disc;    ///< |d|^2 - R^2, d.w, R^2 |w|^2 - |d x w|^2, R = r_a + r_b.
  N touch_gap;     ///< Distance that separates touching from apart [m].
};

/// Where a body is `s` after a place p, velocity v and acceleration a.
template <class N>
[[gnu::always_inline]] inline Triple<N> moved(const Triple<N>& p, const Triple<N>& v, const Triple<N>& a,
                                              const N& s) {
  return p + s * (v + (s / 2) * a);
}

template <class N>
[[gnu::always_inline]] inline N length1(const Triple<N>& a) {
  const auto size = [](const N& x) { return x < 0 ? -x : x; };
  return size(a.x) + size(a.y) + size(a.z);
}

template <class N>
[[gnu::always_inline]] inline Pair<N> pair(const Triple<N>& pa, const Triple<N>& va, const Triple<N>& pb,
                                           const Triple<N>& vb, const N& reach) {
  Pair<N> p;
  p.d = pa - pb, p.w = va - vb;
  p.c = dot(p.d, p.d) - reach * reach, p.b = dot(p.d, p.w);
  const Triple<N> turn = cross(p.d, p.w);
  p.disc = reach * reach * dot(p.w, p.w) - dot(turn, turn);
  p.touch_gap = rounding * (length1(pa) + length1(pb) + reach);
  return p;
}

/// Time from `base` to the contact of two spheres.
///   f(t) = |d + w t + a t^2/2|^2 - R^2
/// a = 0 (both fly): t = (|d|^2 - R^2) / (-d.w + sqrt(R^2 |w|^2 - |d x w|^2)), the cross product in place of
/// (d.w)^2 - |w|^2 (|d|^2 - R^2) because it does not cancel in a grazing hit; the caller sees to b < 0 and
/// disc >= 0, without which they part or pass.  Else a quartic.
/// Touching spheres: f(0) = 0 is taken out as a factor, and f'(0) = 0 as another one.
template <class N>
[[gnu::always_inline]] inline N contact_in_flight(const Pair<N>& p) {
  return p.c / (root(p.disc < 0 ? N{} : p.disc) - p.b);
}
Real contact_accelerated(const Vector3& d, const Vector3& w, const Vector3& a, Real c, Real b, bool touch);

struct Meeting {
  Time time;
  bool overlap;  ///< By more than rounding, at the base.
};

inline Triple<Real> triple(const Vector3& v) { return {v.x(), v.y(), v.z()}; }
inline Vector3 vector(const Triple<Real>& t) { return {t.x, t.y, t.z}; }

inline Meeting contact(const Flight& one, const Flight& other) {
  const Time base = std::max(one.since, other.since);
  const Real s = static_cast<Real>(base - one.since), z = static_cast<Real>(base - other.since);
  const Triple<Real> ga = triple(one.acceleration), gb = triple(other.acceleration);
  const Triple<Real> va = triple(one.velocity), vb = triple(other.velocity);
  const Pair<Real> p = pair(moved(triple(one.position), va, ga, s), va + s * ga,
                            moved(triple(other.position), vb, gb, z), vb + z * gb, one.radius + other.radius);
  const Vector3 a = one.acceleration - other.acceleration;
  const bool alike = a.isZero(0) || size(a) <= rounding * (size(one.acceleration) + size(other.acceleration));
  if (alike && p.c > 0 && (p.b >= 0 || p.disc < 0)) return {std::numeric_limits<Time>::infinity(), false};

  const Real reach = one.radius + other.radius;
  const bool touch = p.c <= 2 * reach * p.touch_gap;
  Real b = p.b;
  if (touch) b = rounded(b, (length1(va + s * ga) + length1(vb + z * gb)) * reach);
  Real t = never;
  if (!alike) {
    t = contact_accelerated(vector(p.d), vector(p.w), a, p.c, b, touch);
  } else if (b < 0) {
    t = touch ? Real(0) : contact_in_flight(p);
  }
  return {base + static_cast<Time>(t), p.c < -16 * reach * p.touch_gap};
}

}  // namespace cylon::engine::ballistic
