// Steps that divide a scenario's duration, all multiples of one coarse grid, so that every run can be looked
// at at the same times.
#pragma once

#include "harness/scenario/scenario.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cylon::study {

struct Ladder {
  std::int64_t samples = 1;         ///< M: the times k T/M are common to all runs.
  std::vector<std::int64_t> steps;  ///< Multiples of M, ascending: from the coarsest step to the finest.
};

/// The coarsest M whose step is about `divisor` (a power of two) times the nominal one, or as near to that as
/// `fewest` samples and the times of recorded truths allow.
std::int64_t coarsest_samples(const scenario::Scenario&, std::int64_t divisor, std::int64_t fewest);

/// M, M 2, M 4, … steps: from about 64 times the nominal step, or as near to that as at least 16 samples and
/// the times of recorded truths allow, `rungs` in all, with at most `most` steps.  Always one rung at least.
Ladder ladder(const scenario::Scenario&, int rungs, std::int64_t most);

/// M, M 2, M 4, … steps from the same coarsest one, none below `finest` [s]; then, where it is a tenth finer
/// than the last of these, the multiple of M whose step is nearest above `finest`.
Ladder ladder_down_to(const scenario::Scenario&, double finest);

/// The steps [s] that a user gives.  Throws core::InputError where one does not fit the duration, or where
/// they have fewer than 8 times in common.
Ladder ladder(const scenario::Scenario&, std::span<const double> steps);

/// "5/1248", or the scenario's own word for its nominal step: as --dt takes it.
std::string step_text(const scenario::Scenario&, std::int64_t steps);

/// The number of steps of the nominal step.
std::int64_t nominal_steps(const scenario::Scenario&);

}  // namespace cylon::study
