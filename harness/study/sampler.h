// One time sample of a cell: a fresh worker process on one processor, warmed up, and the least of some
// repetitions. The process is the sample; more repetitions in it only make it less noisy.
#pragma once

#include "harness/core/scene.h"
#include "harness/process/client.h"
#include "harness/process/engines.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cylon::study {

/// How workers are kept on one processor, where moving from one to another costs more than a regression.
struct Pinning {
  std::vector<std::string>
      prefix;  ///< Before the worker's command: "taskset -c 1"; empty: they run anywhere.
  std::string says;
};

/// `taskset` with the last processor that this process may use; found out once.
const Pinning& pin_to_one_processor();

/// The engine with a worker that the prefix starts.
process::EngineChoice pinned(process::EngineChoice, const Pinning&);

/// How long and how often.
struct SampleRule {
  int repetitions = 8;          ///< Of which the least is taken; >= 1.
  double least_seconds = 1e-3;  ///< Of one repetition: as many runs as that takes, summed [s].
  double most_seconds = 0.05;   ///< Of one run: longer ones are cut to their first steps [s].
  int most_runs = 250;          ///< In one repetition: runs too short even so are not timed.
};

/// What is timed, the same for both builds.
struct SamplePlan {
  const core::Scene* scene = nullptr;
  double dt = 0;           ///< [s]
  std::int64_t steps = 0;  ///< Of each run.
  std::int64_t of = 0;     ///< Steps of the whole scenario.
  int runs = 1;            ///< In each repetition.
  int repetitions = 8;
  bool with_load = false;  ///< The integrator controls its error, and may solve while it loads.

  std::string says() const;  ///< "5000 steps, the least of 8 times 3 runs"
};

struct Sample {
  double seconds = 0;        ///< CPU time of a run, > 0 [s]; there is no failure then.
  std::string failure;       ///< "crash: killed by SIGSEGV"
  std::string version = {};  ///< Of the engine, where it ran.
};

/// Plans by a few runs of the engine; or says why there is nothing to time.  Throws what process::run throws.
struct Planned {
  std::optional<SamplePlan> plan;
  std::string reason;
  bool failed = false;  ///< It did not run; else it is too short to time.
};
Planned plan_samples(const process::EngineChoice&, const core::Scene&, double dt, std::int64_t steps,
                     const SampleRule&, const process::Limits&);

/// Starts a worker and takes one sample.  Throws what process::run throws.
Sample take_sample(const process::EngineChoice&, const SamplePlan&, const process::Limits&);

/// Sums of `runs` neighbours, the least of them divided by their number.
double least_of(const std::vector<process::Repetition>&, int runs, bool with_load);

}  // namespace cylon::study
