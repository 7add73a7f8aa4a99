// The CPU time of the steps that a worker makes, without what it does between them.
#pragma once

#include <cstdint>

namespace cylon::process {

/// CPU time of this process, of all its threads [ns].
double process_cpu_ns();

/// Times bursts of steps; a burst is the steps up to the next sample.  A batch is the bursts between two
/// writes.
///
/// Up to 1000 bursts: the CPU clock is read around each (its own cost subtracted), which what else the
/// machine does cannot disturb.  More: per batch, CPU time x (wall time inside bursts / wall time of the
/// batch), so that only the cheap clock (25 ns, subtracted) is read per burst; good to some 20 ns per step,
/// and too low where the worker is interrupted between bursts.
class StepTimer {
 public:
  explicit StepTimer(std::int64_t bursts);

  void begin_batch();
  void begin_burst();
  void end_burst();
  void end_batch();

  /// Of all bursts so far; complete at the end of a batch.
  double total_ns() const { return total_; }

 private:
  bool few_;
  double cost_, total_ = 0, cpu_ = 0, wall_ = 0, inside_ = 0, burst_ = 0;
};

}  // namespace cylon::process
