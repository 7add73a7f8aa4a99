// Whether the lengths of a data set are as long as it says, from the data alone: two signs that share no number.
#pragma once

#include "harness/validation/score.h"

namespace cylon::validation {

/// Ratios of measured to true length; each is 1 where lengths are right.
struct LengthScale {
  Estimate
      flight;  ///< Mean over runs of (fitted fall)/(gravity of the scene), from frames before the first touch.
  Estimate
      rest;  ///< Mean over runs of (height of the centre)/(half the thickness along up), from runs that end at rest.
};

/// Touching counts from `clearance` [m] above the scene's plane.  Fewer than eight frames of flight, or a last tenth of a
/// second with more than 1 mm of motion, leave a run out.  Throws core::InputError for a scene that has not exactly one
/// plane, or no uniform gravity.
LengthScale length_scale(const measured::Experiment&, double clearance = 0.01);

/// Height of the body's lowest point above the scene's plane [m].
double gap(const measured::Experiment&, const core::BodyState&);

}  // namespace cylon::validation
