// The worker's side of the protocol around any Simulator: commands in, states out, nothing else.
#pragma once

#include "harness/core/simulator.h"

namespace cylon::process {

/// Answers commands from `in_fd` on `out_fd` until quit or the end of input; returns the exit status: 0, or 1
/// when nobody listens any more.  Nothing but this loop may write to `out_fd`.  What the simulator throws
/// while stepping escapes on purpose: the process dies of it and the parent sees a crash.
///
/// step_ns is the thread CPU time of the steps without reading, watching and sending: per batch of states
/// between two writes, CPU time x (wall time inside bursts of steps / wall time of the batch).  A burst is
/// the steps up to the next sample, or one step while pairs are watched, so that no clock is read per step in
/// a sparse run and only the cheap one (25 ns, subtracted) in a dense one, whose figure is good to some 20 ns
/// per step.
int serve(core::Simulator&, int in_fd, int out_fd);

}  // namespace cylon::process
