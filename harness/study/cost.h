// What a run costs, measured apart from any recording.
#pragma once

#include "harness/core/scene.h"
#include "harness/process/client.h"
#include "harness/results/verdict.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cylon::study {

/// What is timed.
struct Timed {
  process::EngineChoice engine;
  core::Setup setup;
  std::int64_t steps = 0;
};

/// The least times of some runs in one worker after one that only warms it: as many as 20 ms have room for,
/// by `guess` [s], the CPU time of a run; at least 2, at most 200.  Throws what process::run throws.
struct TimedOnce {
  std::optional<process::Repetition> least;  ///< Nothing where the engine fails.
  results::Status status = results::Status::pass;
  std::string reason;  ///< Where it did not pass.
};
TimedOnce time_once(const Timed&, const core::Scene&, double guess, const process::Limits&);

/// The least of each time that is not below 0.7 of its median: a clock that a scheduler stopped half way may
/// read far too little, and a least of all would seek out such readings.  Requires times not empty.
process::Repetition typical_least(std::vector<process::Repetition> times);

/// The smaller of each time.
process::Repetition least(const process::Repetition&, const process::Repetition&);

/// CPU seconds per simulated second.  An integrator that controls its error may solve while it loads: there
/// the load counts.
double cost(const process::Repetition&, bool adaptive, double duration);

}  // namespace cylon::study
