// The stepper that a plan asks for.
#pragma once

#include "engine/plan.h"
#include "engine/stepper.h"

#include <memory>

namespace cylon::engine {

/// From the instant `start` on, with model.motions the motion then and model.bodies as at t = 0; the first
/// step ends at the next multiple of options.dt.  `start` is a multiple itself unless the path is events.
/// Paths on which nothing depends on time (exact, free, ballistic) start at 0: their own times count from
/// `start`.
std::unique_ptr<Stepper> make_stepper(const Model&, const Options&, const Plan&, Time start = 0);

}  // namespace cylon::engine
