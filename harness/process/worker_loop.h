// The worker's side of the protocol around any Simulator: commands in, states out, nothing else.
#pragma once

#include "harness/core/simulator.h"

namespace cylon::process {

/// Answers commands from `in_fd` on `out_fd` until quit or the end of input; returns the exit status: 0, or 1
/// when nobody listens any more.  Nothing but this loop may write to `out_fd`.  What the simulator throws
/// while stepping escapes on purpose: the process dies of it and the parent sees a crash.
///
/// step_ns is the thread CPU time of the steps without reading, watching and sending.  A burst is the steps
/// up to the next sample, or one step while pairs are watched.  Up to 1000 bursts: the CPU clock around each
/// (its own cost subtracted), which what else the machine does cannot disturb.  More: per batch of states
/// between two writes, CPU time x (wall time inside bursts / wall time of the batch), so that only the cheap
/// clock (25 ns, subtracted) is read per burst; good to some 20 ns per step, and too low where the worker is
/// interrupted between bursts.
int serve(core::Simulator&, int in_fd, int out_fd);

}  // namespace cylon::process
