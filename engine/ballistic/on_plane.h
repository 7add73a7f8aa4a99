// How a sphere moves on a plane that gravity presses it against: at rest, sliding straight, or rolling.
#pragma once

#include "engine/ballistic/impact.h"
#include "engine/shape.h"

namespace cylon::engine::ballistic {

struct Supported {
  Vector3 acceleration = Vector3::Zero();  ///< [m/s^2]
  Vector3 torque = Vector3::Zero();        ///< About the centre [N m].
  Time slip_ends = 0;                      ///< After this time; infinite where it does not [s].
  bool straight = true;                    ///< false: it slides along a curve, which this does not know.
};

/// With the slip u = v + r n x w at the contact, tangential gravity g_t, pressure N = -m g.n, k = 1 + m r^2/I
/// (7/2 for a solid sphere):
///   slides:  v' = g_t - mu (N/m) u/|u|,  u' = g_t - k mu (N/m) u/|u|;  straight where g_t is along u
///   rolls where |g_t| <= k mu N/m (solid sphere: tan <= 7 mu/2):  v' = g_t (1 - 1/k)
/// A point (r = 0, k = 1) "rolls" by standing still.  `slips` = false: the slip is zero but for rounding.
Supported on_plane(const Side&, Real mass, const Vector3& n, const Vector3& gravity, Real mu, bool slips);

}  // namespace cylon::engine::ballistic
