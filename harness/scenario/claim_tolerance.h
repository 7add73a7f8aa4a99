// How well a claim must hold: `tolerance`, and whether its truth is good enough for it.
#pragma once

#include "harness/core/claim.h"
#include "harness/scenario/reader.h"

namespace cylon::scenario {

/// Reads the table `tolerance` of a claim whose observable and reduction are known.
core::Tolerance read_tolerance(const Table& tolerance, const core::Claim&);

/// Sets the truth's error in the observable's unit.  Fails where that is more than a tenth of the
/// tolerance, in a run at `step`.  The table is the claim's.
void check_tolerance(const Table& claim, core::Claim&, const core::Scene&, double duration, double step);

}  // namespace cylon::scenario
