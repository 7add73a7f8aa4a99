#include "harness/study/cost.h"

#include <algorithm>

namespace cylon::study {

process::Repetition least(const process::Repetition& a, const process::Repetition& b) {
  return {std::min(a.load_seconds, b.load_seconds), std::min(a.step_seconds, b.step_seconds)};
}

double cost(const process::Repetition& time, bool adaptive, double duration) {
  return (time.step_seconds + (adaptive ? time.load_seconds : 0)) / duration;
}

std::optional<process::Repetition> time_once(const Timed& timed, const core::Scene& scene, double guess,
                                             const process::Limits& limits) {
  constexpr double room = 0.02;  // [s]: some hundred ticks of the clock that a scheduler disturbs
  process::RunRequest request;
  request.scene = &scene;
  request.setup = timed.setup;
  request.steps = timed.steps;
  request.every = std::max<std::int64_t>(1, timed.steps);
  request.repetitions = std::clamp(static_cast<int>(room / std::max(guess, 1e-6)), 1, 200);
  const process::RunOutcome outcome = process::run(timed.engine, request, limits);
  if (outcome.repetitions.empty()) return std::nullopt;
  process::Repetition best = outcome.repetitions.front();
  for (const process::Repetition& one : outcome.repetitions) best = least(best, one);
  return best;
}

}  // namespace cylon::study
