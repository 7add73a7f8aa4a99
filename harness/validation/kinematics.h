// Whether the columns of a data set go together, from the data alone: its velocities with differences of its places.
#pragma once

#include "harness/validation/score.h"

namespace cylon::validation {

/// Slopes of the steps from frame to frame over (mean of both velocities)/rate, each the mean over runs of
///     sum step . velocity / sum velocity . velocity,
/// 1 where units, axes, order of columns and rate are right, near 0 for columns that have nothing to do with each other.
struct Kinematics {
  Estimate velocity;  ///< Of positions over velocities; not known for a chain.
  Estimate spin;      ///< Of turns over angular velocities, or of a chain's angles over its rates.
};

Kinematics kinematics(const measured::Experiment&);

/// Whether a slope is 1 to a tenth, which impacts between frames and filters of rates leave.
Answer goes_together(const Estimate& slope);

}  // namespace cylon::validation
