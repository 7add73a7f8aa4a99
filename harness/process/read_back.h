// Most cross-engine "errors" are set-up errors: did the engine start where the scene says?
#pragma once

#include "harness/core/scene.h"

#include <optional>
#include <string>

namespace cylon::process {

/// The first body and quantity whose read-back differs from the scene's initial state, with both values;
/// nothing where all agree: |difference| <= epsilon max(1, largest magnitude of that quantity in the scene),
/// per vector in its SI unit, orientations as |q - q'| after the sign fix.  epsilon is 1e-12 for "double" and
/// 1e-6 for "float": some roundings of a change of variables (inertia axes, joint coordinates), and no more; 4e-6 of
/// angular velocities, which engines that keep angular momenta divide by unlike moments of inertia.
/// NaN differs from everything.
std::optional<std::string> read_back_difference(const core::Scene&, const core::State& read_back,
                                                const std::string& precision);

}  // namespace cylon::process
