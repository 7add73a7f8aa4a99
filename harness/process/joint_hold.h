// For what begins a scene anew: poses and velocities that fit the joints.
// Knows no engine and no protocol.
#pragma once

#include "harness/core/held_joint.h"

#include <vector>

namespace cylon::process {

/// Takes gaps away, by the shortest way in the metric of the masses; at most ten Newton steps, each of which
/// leaves the square of what was left.  Then fit_velocities.
void fit(const core::Scene&, const std::vector<core::HeldJoint>&, core::State&);

/// Velocities that the joints allow, by impulses of the joints alone:
///   v+ = v - M^-1 J^T (J M^-1 J^T)^+ J v
/// so that momentum changes by what the joints give, and the world's joints take what is missing.
void fit_velocities(const core::Scene&, const std::vector<core::HeldJoint>&, core::State&);

/// An impulse [N s] at the centre of mass of a body that is not locked, and an angular impulse [N m s] beside it, world
/// axes: v += J/m, w += I^-1 L, then the joints' answer.  About an axis without inertia nothing turns.
void kick(const core::Scene&, const std::vector<core::HeldJoint>&, core::State&, int body,
          const core::Vector3& impulse, const core::Vector3& angular_impulse = core::Vector3::Zero());

}  // namespace cylon::process
