// The same phenomenon from another start: what a setting that was chosen on one start is checked on.
#pragma once

#include "harness/scenario/scenario.h"

#include <optional>

namespace cylon::scenario {

/// The scenario with all velocities 1 + amount times as large; where nothing moves at first, or a truth does
/// not serve that scene, gravity so much stronger, else springs so much stiffer.  All of these keep joints
/// and contacts closed.  Truths are those of the new scene, and tolerances stay.  Nothing where a truth is
/// recorded data, or serves none of these scenes.  |amount| < 1.
std::optional<Scenario> varied(const Scenario&, double amount);

}  // namespace cylon::scenario
