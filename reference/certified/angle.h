// Along which a spin changes an angle of a joint.
#pragma once

#include "harness/core/scene.h"
#include "reference/certified/graph.h"

namespace cylon::certified {

/// The axes h, which `to` carries, and u, which `body` carries, where the joint has one; and their rates.
struct Axes {
  Vector h, u;
  Vector h_rate, u_rate;
};

inline Vector over(const Vector& a, Expr by) { return {a[0] / by, a[1] / by, a[2] / by}; }

/// g with  angle' = g . (w_body - w_to),  and g'.  Of one axis it is that axis, of two that stay square the one which is
/// asked for; of three, with n = h x u and N = n . n,
///   first  u x n/N,   second  n x h/N,   third  n/sqrt N,
/// each square to the axes of the other two angles.
inline Vector angle_direction(const core::JointKind& kind, core::Ordinal which, const Axes& a) {
  using core::Ordinal;
  if (kind.turn != core::JointTurn::about_three_axes) return which == Ordinal::first ? a.h : a.u;
  const Vector n = cross(a.h, a.u);
  const Expr square = dot(n, n);
  if (which == Ordinal::third) return over(n, sqrt(square));
  return over(which == Ordinal::first ? cross(a.u, n) : cross(n, a.h), square);
}

//   (u x n/N)' = (u' x n + u x n' - 2 (n . n') g)/N,   (n/sqrt N)' = (n' - (e . n') e)/sqrt N
inline Vector angle_direction_rate(const core::JointKind& kind, core::Ordinal which, const Axes& a) {
  using core::Ordinal;
  if (kind.turn != core::JointTurn::about_three_axes) return which == Ordinal::first ? a.h_rate : a.u_rate;
  const Vector n = cross(a.h, a.u), n_rate = cross(a.h_rate, a.u) + cross(a.h, a.u_rate);
  const Vector g = angle_direction(kind, which, a);
  const Expr square = dot(n, n);
  if (which == Ordinal::third) return over(n_rate - dot(g, n_rate) * g, sqrt(square));
  const Vector product = which == Ordinal::first ? cross(a.u_rate, n) + cross(a.u, n_rate)
                                                 : cross(n_rate, a.h) + cross(n, a.h_rate);
  const Expr turned = dot(n, n_rate);
  return over(product - (turned + turned) * g, square);
}

}  // namespace cylon::certified
