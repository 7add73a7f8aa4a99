#include "harness/study/runner.h"

#include <utility>

namespace cylon::study {

Runner worker_runner(const process::EngineChoice& engine, const process::Limits& limits,
                     process::RunOutcome* last) {
  return [=](const core::Scene& scene, double dt, std::int64_t steps, std::int64_t every) {
    process::RunRequest request;
    request.scene = &scene;
    request.setup.dt = dt, request.steps = steps, request.every = every;
    process::RunOutcome outcome = process::run(engine, request, limits);
    const bool failed = outcome.status != results::Status::pass || !outcome.recording;
    core::Recording recording;
    if (!failed) recording = std::move(*outcome.recording);
    if (last) *last = outcome;
    if (failed) throw RunFailed{std::move(outcome)};
    return recording;
  };
}

}  // namespace cylon::study
