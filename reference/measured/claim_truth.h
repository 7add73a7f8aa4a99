// Measured motions as truths of claims: `follows = { measured = "…", run = "…" }`.
#pragma once

#include "harness/core/claim.h"
#include "reference/measured/experiment.h"

namespace cylon::measured {

/// A run of an experiment as the truth of a scene that has the measured bodies, by their names.  It is known at the frames after the
/// first.  Its uncertainty: the noise of those, the errors of the start, what surfaces are said to be.
/// Throws core::InputError where the scene lacks a measured body, or has another that moves; where it does not start as the run does,
/// within a hundredth of a standard deviation, with the start that it needs; where no noise or no error of the start is stated; where
/// a surface may be off by more than there is of it.
core::MeasuredTruth truth(const Experiment&, const Run&, const core::Scene&);

/// Lets scenarios be read whose claims follow measured motions.
void serve_scenarios();

}  // namespace cylon::measured
