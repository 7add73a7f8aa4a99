// How far apart two runs end that start one ulp apart: what a verdict on a chaotic motion is worth.
#pragma once

#include "harness/core/claim.h"
#include "harness/core/recording.h"
#include "harness/core/scene.h"

namespace cylon::study {

/// The scene with one coordinate of its initial motion larger by one ulp: of the positions and velocities of
/// the bodies that move, those that are not zero are counted in order, and copy i of n takes the one at (2 i
/// + 1)/(2 n) of them.  Where all are zero, the first body's x is 2^-52 m.  Requires 0 <= copy < copies.
core::Scene one_ulp_apart(const core::Scene&, int copy, int copies);

/// How far two runs of a scene are from each other at the last sample up to the claim's horizon, in the
/// observable's unit; of an event, the difference of its quantity, NaN where only one of them has it.
double spread(const core::Claim&, const core::Scene&, const core::Recording&, const core::Recording&);

}  // namespace cylon::study
