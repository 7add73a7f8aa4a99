// One engine as a function from scenes to recordings, for many short runs.
#pragma once

#include "harness/study/runner.h"

namespace cylon::study {

/// As worker_runner, but all runs of a thread in one worker: a process::Session for each thread that calls it.
Runner session_runner(const process::EngineChoice&, const process::Limits&);

}  // namespace cylon::study
