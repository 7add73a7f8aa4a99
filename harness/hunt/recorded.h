// Oracles that read a recording themselves, as no claim of a scenario asks for it.
#pragma once

#include "harness/hunt/oracle.h"

namespace cylon::hunt {

/// Farthest that a locked body gets from its start, in units of its size.
std::optional<Reading> read_locked(const core::Scene&, const core::Recording&);

/// Joints and contacts do no work, so that the kinetic energy T obeys d sqrt(2 T)/dt <= sqrt(sum F^2/m), and
///   V = sqrt(2 T/M) <= V(0) + t sqrt(sum F^2/(m M)),  M = sum m, F the largest force on a body.
/// What V is above that [m/s].
std::optional<Reading> read_speed(const core::Scene&, const core::Recording&);

/// |sum of the contact forces + m g| of the worst body in the last step [N].  Nothing where forces are not told.
std::optional<Reading> read_statics(const core::Scene&, const core::Recording&);

/// Of one sphere that falls on one plane:  E = v_n^2/2 + g_n (gap), which the first blow leaves e^2 of [m^2/s^2].  Read three
/// steps after the blow; nothing where the run ends before, or the next blow is nearer than that.
std::optional<Reading> read_rebound(const core::Scene&, const core::Recording&);

/// Of one box that begins to slide on one level plane, and cannot tip:  x(t) = v t - mu g t^2/2 along v, and rest from
/// t = v/(mu g) on.  Its farthest place from that, of the way that it goes [m].
std::optional<Reading> read_slide(const core::Scene&, const core::Recording&);

/// Of balls that no torque turns: how far each is from the turn w t that its first angular velocity makes.
std::optional<Reading> read_spin(const core::Scene&, const core::Recording&);

}  // namespace cylon::hunt
