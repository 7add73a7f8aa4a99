// Runs as a page draws them, as JSON.  Rounded to 1e-7 and thinned to 300 frames: pictures, and no data.
#pragma once

#include "harness/validation/drawing.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <span>

namespace cylon::cli {

/// What was measured of those runs: names and unit of the curves, and for each run its times and values by curve; of a free body also
/// how far its heights lie off the fall of the scene's gravity.
nlohmann::ordered_json measured_json(const measured::Experiment&, std::span<const std::size_t> runs);

/// What an engine predicts of one of them.
nlohmann::ordered_json to_json(const validation::Drawing&);

/// Whether the columns of the data go together.
nlohmann::ordered_json kinematics_json(const measured::Experiment&);

/// What the data say of their lengths.
nlohmann::ordered_json lengths_json(const measured::Experiment&);

}  // namespace cylon::cli
