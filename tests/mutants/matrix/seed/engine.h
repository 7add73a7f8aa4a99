// A small engine in the seed's structure, with the physics put right, or all but one of its errata.
#pragma once

#include "harness/core/simulator.h"
#include "tests/mutants/matrix/seed/faults.h"

#include <memory>

namespace cylon::mutants::seed {

/// Second order: half a step of motion, the forces' push, half a step of motion; impacts and the water's
/// surface are located within the step.
std::unique_ptr<core::Simulator> make_engine(Faults);

}  // namespace cylon::mutants::seed
