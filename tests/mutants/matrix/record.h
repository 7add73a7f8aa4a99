// A run in this process: what a worker records, without the worker.
#pragma once

#include "harness/core/recording.h"
#include "harness/core/simulator.h"
#include "harness/study/cell.h"

namespace cylon::mutants {

/// Requires unsupported(scene, setup) to be empty.  The first state is what the simulator reads back at t =
/// 0.
core::Recording record(core::Simulator&, const core::Scene&, const core::Setup&, const study::Sampling&);

}  // namespace cylon::mutants
