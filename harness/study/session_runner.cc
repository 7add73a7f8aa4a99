#include "harness/study/session_runner.h"

#include "harness/process/session.h"

#include <atomic>
#include <memory>
#include <utility>

namespace cylon::study {

Runner session_runner(const process::EngineChoice& engine, const process::Limits& limits) {
  static std::atomic<std::uint64_t> runners = 0;
  return [=, me = ++runners](const core::Scene& scene, double dt, std::int64_t steps, std::int64_t every) {
    // Of the runner that this thread called last.
    thread_local std::pair<std::uint64_t, std::unique_ptr<process::Session>> own;
    if (own.first != me) own = {me, std::make_unique<process::Session>(engine.row, limits)};
    process::RunRequest request;
    request.scene = &scene;
    request.setup.dt = dt, request.steps = steps, request.every = every;
    process::RunOutcome outcome = own.second->run(engine, request);
    if (!outcome.recording) throw RunFailed{std::move(outcome)};
    return std::move(*outcome.recording);
  };
}

}  // namespace cylon::study
