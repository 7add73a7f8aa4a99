// The worker's side of the protocol around any Simulator: commands in, states out, nothing else.
#pragma once

#include "harness/core/simulator.h"

namespace cylon::process {

/// Answers commands from `in_fd` on `out_fd` until quit or the end of input; returns the exit status: 0, or 1
/// when nobody listens any more.  Nothing but this loop may write to `out_fd`.  What the simulator throws
/// while stepping escapes on purpose: the process dies of it and the parent sees a crash.
/// step_ns is the CPU time of the steps, of all threads, without reading, watching and sending: StepTimer says how.
int serve(core::Simulator&, int in_fd, int out_fd);

}  // namespace cylon::process
