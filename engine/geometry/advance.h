// How long two shapes surely stay apart: what keeps anything from tunnelling.
#pragma once

#include "engine/geometry/separation.h"

namespace cylon::engine {

/// Bounds on a body's velocity over the step.
struct Speed {
  Vector3 velocity = Vector3::Zero();  ///< Of the reference point, at the start [m/s].
  Real change = 0;                     ///< |v(t) - v(0)| stays below this [m/s]; acceleration bound x step.
  Real spin = 0;                       ///< |w(t)| stays below this [rad/s].
  Real radius = 0;                     ///< bounding_radius of its shape [m].
};

/// A time for which shapes `gap` apart surely do not touch [s]:
///   dt = gap / (max(0, -n.(v_a - v_b)) + change_a + change_b + spin_a radius_a + spin_b radius_b),
/// the plane with normal n between them is not reached sooner from both sides.  0 where gap <= 0; infinite
/// where nothing approaches.  B. Mirtich, Impulse-based Dynamic Simulation (1996), section 2.3.
Real safe_time(const Separation&, const Speed&, const Speed& other);

/// The same where only a bound on the relative speed is known: |v_a - v_b| <= speed [m/s].
Real safe_time(Real gap, Real speed, Real spin, Real radius, Real other_spin, Real other_radius);

}  // namespace cylon::engine
