// What claims read of a run's last step, where an engine tells its forces: balances and what joints exert.
#pragma once

#include "harness/core/claim.h"
#include "harness/core/recording.h"

#include <optional>
#include <string>

namespace cylon::core {

/// What the recording lacks for an observable of the last step, in words, or nothing.
std::optional<std::string> untold_of_last_step(const Observable&, const Scene&, const Recording&);

/// How far the claim is from what is required, in the observable's unit; 0 where something is untold of joints.  Needs
/// the claim's truth where it follows one.
double deviation_of_last_step(const Claim&, const Scene&, const Recording&);

/// Why the truth is not good enough for a step of this length, or nothing: its error must be at most a tenth of what is
/// allowed, and grows as 1/dt.
std::optional<std::string> too_short_a_step(const Claim&, const Scene&, const Recording&, double allowed);

/// How far two runs are apart; 0 where something is untold.
double spread_of_last_step(const Observable&, const Scene&, const Recording&, const Recording&);

}  // namespace cylon::core
