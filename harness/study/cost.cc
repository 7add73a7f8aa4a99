#include "harness/study/cost.h"

#include <algorithm>

namespace cylon::study {

process::Repetition least(const process::Repetition& a, const process::Repetition& b) {
  return {std::min(a.load_seconds, b.load_seconds), std::min(a.step_seconds, b.step_seconds)};
}

process::Repetition typical_least(std::vector<process::Repetition> times) {
  const auto of = [&](double process::Repetition::*part) {
    std::sort(times.begin(), times.end(), [&](const auto& a, const auto& b) { return a.*part < b.*part; });
    const double usual = times[times.size() / 2].*part;
    const auto believed =
        std::find_if(times.begin(), times.end(), [&](const auto& t) { return t.*part >= 0.7 * usual; });
    return (*believed).*part;
  };
  return {of(&process::Repetition::load_seconds), of(&process::Repetition::step_seconds)};
}

double cost(const process::Repetition& time, bool adaptive, double duration) {
  return (time.step_seconds + (adaptive ? time.load_seconds : 0)) / duration;
}

TimedOnce time_once(const Timed& timed, const core::Scene& scene, double guess,
                    const process::Limits& limits) {
  constexpr double room = 0.02;  // [s]: some hundred ticks of the clock that a scheduler disturbs
  process::RunRequest request;
  request.scene = &scene;
  request.setup = timed.setup;
  request.steps = timed.steps;
  request.every = std::max<std::int64_t>(1, timed.steps);
  request.repetitions = std::clamp(static_cast<int>(room / std::max(guess, 1e-6)), 2, 200);
  const process::RunOutcome outcome = process::run(timed.engine, request, limits);
  if (outcome.repetitions.empty()) return {std::nullopt, outcome.status, outcome.reason};
  return {typical_least(outcome.repetitions), results::Status::pass, ""};
}

}  // namespace cylon::study
