// The stepper that a plan asks for.
#pragma once

#include "engine/plan.h"
#include "engine/stepper.h"

#include <memory>

namespace cylon::engine {

/// From the instant `start` on; the first step ends at the next multiple of options.dt.
std::unique_ptr<Stepper> make_stepper(const Model&, const Options&, const Plan&, Time start = 0);

}  // namespace cylon::engine
