// When a moving sphere meets a plane or another sphere.
#pragma once

#include "engine/ballistic/flight.h"
#include "engine/ballistic/roots.h"
#include "engine/shape.h"

namespace cylon::engine::ballistic {

/// Part of a sum that may be rounding: some operations of half an ulp each.
inline constexpr Real rounding = 8 * std::numeric_limits<Real>::epsilon();

inline Real size(const Vector3& v) { return v.lpNorm<1>(); }

/// x, or 0 where it may be the rounding of zero.
inline Real rounded(Real x, Real scale) { return std::abs(x) <= rounding * scale ? Real(0) : x; }

/// Distance that separates touching from apart [m].
inline Real touching(const Flight& f, const Plane& plane) {
  return rounding * (size(f.position) + std::abs(plane.offset) + f.radius);
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

/// Time from `base` to the contact of two spheres.  With d = p_a - p_b, w, a the relative position, velocity
/// and acceleration and R = r_a + r_b,
///   f(t) = |d + w t + a t^2/2|^2 - R^2
/// a = 0 (both fly): t = (|d|^2 - R^2) / (-d.w + sqrt(R^2 |w|^2 - |d x w|^2)), the cross product in place of
/// (d.w)^2 - |w|^2 (|d|^2 - R^2) because it does not cancel in a grazing hit.  Else a quartic.
/// Touching spheres: f(0) = 0 is taken out as a factor, and f'(0) = 0 as another one.
Real contact_accelerated(const Vector3& d, const Vector3& w, const Vector3& a, Real c, Real b, bool touch);

struct Meeting {
  Time time;
  bool overlap;  ///< By more than rounding, at the base.
};

inline Meeting contact(const Flight& one, const Flight& other) {
  const Time base = std::max(one.since, other.since);
  const auto at_base = [base](const Flight& f) { return static_cast<Real>(base - f.since); };
  const Real s = at_base(one), z = at_base(other);
  const Vector3 pa = one.position + s * (one.velocity + s / 2 * one.acceleration);
  const Vector3 pb = other.position + z * (other.velocity + z / 2 * other.acceleration);
  const Vector3 va = one.velocity + s * one.acceleration, vb = other.velocity + z * other.acceleration;
  const Vector3 d = pa - pb, w = va - vb;
  const Real reach = one.radius + other.radius, c = d.squaredNorm() - reach * reach;
  Real b = d.dot(w);
  const Vector3 a = one.acceleration - other.acceleration;
  const bool alike = a.isZero(0) || size(a) <= rounding * (size(one.acceleration) + size(other.acceleration));
  Real disc = 0;
  if (alike && c > 0) {  // most pairs part, or pass each other
    if (b < 0) disc = reach * reach * w.squaredNorm() - d.cross(w).squaredNorm();
    if (b >= 0 || disc < 0) return {std::numeric_limits<Time>::infinity(), false};
  }

  const Real touch_gap = rounding * (size(pa) + size(pb) + reach);
  const bool touch = c <= 2 * reach * touch_gap;
  if (touch) b = rounded(b, (size(va) + size(vb)) * reach);
  Real t = never;
  if (!alike) {
    t = contact_accelerated(d, w, a, c, b, touch);
  } else if (b < 0) {
    t = touch ? Real(0) : c / (-b + std::sqrt(disc));
  }
  return {base + static_cast<Time>(t), c < -16 * reach * touch_gap};
}

}  // namespace cylon::engine::ballistic
