// One engine as a function from scenes to recordings: what studies are written in.
#pragma once

#include "harness/core/recording.h"
#include "harness/process/client.h"

#include <cstdint>
#include <functional>

namespace cylon::study {

/// Runs a scene: `steps` steps of `dt` [s], every `every`-th kept, and the end.
using Runner =
    std::function<core::Recording(const core::Scene&, double dt, std::int64_t steps, std::int64_t every)>;

/// An engine did not reach the end of a run.
struct RunFailed {
  process::RunOutcome outcome;
};

/// Each run in a worker of its own.  It throws RunFailed, and what process::run throws; `last`, where given,
/// gets each outcome (its recording moved away), and outlives the runner.
Runner worker_runner(const process::EngineChoice&, const process::Limits&,
                     process::RunOutcome* last = nullptr);

}  // namespace cylon::study
