// The harness's side of the protocol: one scene, one engine, one worker process, and what came of it.
#pragma once

#include "harness/core/engine.h"
#include "harness/core/recording.h"
#include "harness/core/scene.h"
#include "harness/process/child.h"
#include "harness/process/engines.h"
#include "harness/results/verdict.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cylon::process {

struct RunRequest {
  const core::Scene* scene = nullptr;
  core::Setup setup;              ///< What the engine's id states (path, integrator, options) goes before it.
  std::int64_t steps = 0;         ///< >= 0
  std::int64_t every = 1;         ///< Steps between samples, >= 1; the start and the end are always kept.
  std::vector<std::int64_t> at;   ///< Further steps to keep, in any order, in 0..steps.
  std::vector<core::Pair> watch;  ///< Pairs whose bounces and apexes are wanted.
  bool contacts = false;          ///< Those of the last step are wanted, of an engine that tells them.
  int repetitions = 0;            ///< Runs after the first, in the same worker, of which only times are kept.
};

struct Limits {
  double hello_seconds = 10;                        ///< From the spawn to the answer to hello [s].
  double run_seconds = 60;                          ///< Load and run together [s].
  std::size_t memory_bytes = std::size_t{4} << 30;  ///< Resident size of the worker; 0: no limit [bytes].
  double quit_seconds = 0.5;                        ///< From quit to the exit, then it is killed [s].
};

/// Thread CPU time of one run: what the engine did to take the scene, and for all steps together.  Nothing is
/// recorded between the first state and the last.
struct Repetition {
  double load_seconds = 0;  ///< 0 where a worker does not tell.
  double step_seconds = 0;
};

struct RunOutcome {
  std::optional<core::Recording> recording;  ///< Present exactly when the status is pass.
  /// pass: the run reached its end, whatever the numbers; fail: the engine starts from another state than the
  /// scene's; else unsupported, crash, timeout or protocol.
  results::Status status = results::Status::pass;
  std::vector<Repetition> repetitions;  ///< As many as were asked for, exactly when the status is pass.
  std::size_t peak_bytes = 0;           ///< Most that the worker had resident by the end of the first run.
  std::string reason;                   ///< One line; empty when it passed.
  std::string stderr_tail;              ///< At most 4 KiB.
  core::Engine engine;                  ///< As far as it got to introduce itself.
  core::Terms terms{.order = 0};        ///< As far as it got to load; of order 0 before.
};

/// Runs a worker from spawn to end; no process is left behind.  Any number of threads may call it at once.
/// Throws core::InputError where the worker calls the setup impossible (unknown path, integrator or option),
/// where an integrator that does not control its error is given a tolerance, or where the recording would not
/// fit in memory;
/// Interrupted soon after interrupted() is set; std::invalid_argument for a request outside its domain.
RunOutcome run(const EngineChoice&, const RunRequest&, const Limits& = {});

/// Throws core::InputError where the worker calls the choice's path, integrator or options impossible, Interrupted.  It loads
/// one body and runs no step; whatever else goes wrong is for the run of a scene to say.
void require_possible(const EngineChoice&);

/// What an engine says of itself.  Throws Failure where it cannot, Interrupted.
core::Engine describe(const EngineChoice&, const Limits& = {});

}  // namespace cylon::process
