// Events in recorded states and in truths.  Knows the kinds by their signals alone.
#pragma once

#include "harness/core/observable.h"
#include "harness/core/recording.h"
#include "harness/core/scene.h"
#include "harness/core/truth.h"

#include <vector>

namespace cylon::core {

/// Whether EventWatch finds the kind while a run goes on: bounce and apex; the others are found afterwards,
/// in states of every step.
bool watched(EventKind);

/// The observable's events, in order of time.  A watched kind's are those of the recording.  Any other's are
/// found on the arcs between its states, which must be those of every step:
/// - a sign change of the signal that goes 1e-6 of its largest size beyond zero on either side is an event,
/// at
///   the root of the cubic through the two samples on either side (crossing, where the force jumps: through
///   the four before); what stands beside the signal is read there by the same cubic.  Error: O(dt^4).
/// - precession: the root of the unwrapped azimuth less 2 pi k, by the same cubic.
/// - roll: slip that was above a hundredth of its largest falls below a thousandth; the arc of the last three
///   samples above is followed to zero.  Exact for constant friction.
std::vector<Event> find_events(const Observable&, const Scene&, const Recording&);

/// The truth with its events of the observable's kind: those that it states, or else found in its states up
/// to `horizon`, by scanning at least 64 times, at most 2048 of them `step` apart and more only where others, closer by
/// the golden ratio, show other events, and bisection to the last digit (watched kinds: EventWatch over states `step` apart, and half as far).  Adds
/// the bound on their times to error.time: error of the signal / its slope; watched kinds: what half the step
/// changes. A truth that is known at some times only is given back as it is.  Throws OutOfDomain where events follow
/// each other too fast for 2^20 times.
Truth with_events(const Observable&, const Scene&, const Truth&, double horizon, double step);

}  // namespace cylon::core
