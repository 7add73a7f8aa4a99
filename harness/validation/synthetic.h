// Experiments whose truth is known: what an engine does with parameters that one chooses, seen with the noise that an experiment
// states.
#pragma once

#include "harness/study/runner.h"
#include "reference/measured/experiment.h"

#include <cstdint>
#include <span>

namespace cylon::validation {

/// Whether friction and restitution of a run are those values, or draws around them of the stated deviations.
enum class Surfaces { exact, drawn };

/// The experiment `like` with other data: its model with those values runs from the first frame of each of `runs`, for as many
/// frames as that has, and every frame is then seen with independent errors of the stated covariance.  A measured state is the
/// start of a window and what the window before is compared with; so one covariance serves both where the stated noise of positions
/// and angles is that of starts.  The start of the run is a draw, too.  Deterministic by the seed, on every machine.
measured::Experiment synthetic(const measured::Experiment& like, std::span<const std::size_t> runs,
                               std::span<const double> values, const study::Runner&, std::uint64_t seed,
                               Surfaces = Surfaces::exact);

}  // namespace cylon::validation
