// What an engine predicts of a measured motion, at its frames.
#pragma once

#include "harness/study/runner.h"
#include "reference/measured/experiment.h"

#include <vector>

namespace cylon::validation {

/// States of all bodies at `frames` frames from the scene's start on.  Throws what the runner does.
std::vector<core::State> whole_path(const measured::Experiment&, const core::Scene&, std::size_t frames,
                                    const study::Runner&);

/// The same of the measured bodies alone.
std::vector<core::State> predicted(const measured::Experiment&, const core::Scene&, std::size_t frames,
                                   const study::Runner&);

bool finite(const std::vector<core::State>&);

}  // namespace cylon::validation
