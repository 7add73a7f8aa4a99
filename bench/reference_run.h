// Another engine on the same scene, its step halved until an error is reached.
#pragma once

#include "bench/own_run.h"
#include "harness/process/client.h"

#include <map>
#include <utility>

namespace cylon::bench {

struct References {
  const core::Scene& scene;
  double duration;
  const Subject& subject;
  double budget;
  mutable std::map<std::pair<std::string, std::int64_t>, Run> seen;

  Run run(const process::EngineChoice& choice, std::int64_t steps) const {
    process::RunRequest request;
    request.scene = &scene;
    request.setup.dt = duration / static_cast<double>(steps);
    request.steps = steps;
    request.every = steps / samples;
    const auto outcome = process::run(choice, request);
    if (!outcome.recording) return {outcome.reason, static_cast<double>(steps)};
    Run r{choice.id, static_cast<double>(steps), 0, outcome.recording->cpu_seconds};
    for (std::size_t k = 0; k < samples; ++k) {
      const double e = subject.error(outcome.recording->states[k + 1], subject.truths[k]);
      r.error = std::isfinite(e) ? std::max(r.error, e) : INFINITY;
    }
    return r;
  }

  // Halves the step until the error is reached; `nearest` is the best that was seen.
  std::optional<Run> reach(const process::EngineChoice& choice, double target, Run& nearest) const {
    for (std::int64_t steps = std::int64_t{64} * samples; steps < 200'000'000; steps *= 2) {
      const auto [place, is_new] = seen.try_emplace({choice.id, steps});
      if (is_new) place->second = run(choice, steps);
      const Run& r = place->second;
      if (!std::isfinite(r.cpu)) {  // an engine may not survive a step that is far too long
        if (nearest.how.empty()) nearest = r;
        if (steps < 10'000) continue;
        break;
      }
      if (r.error < nearest.error) nearest = r;
      if (r.error <= target) {
        const Run between =
            run(choice, samples * static_cast<std::int64_t>(r.steps / samples / std::sqrt(2.0)));
        return between.error <= target ? between : r;
      }
      if (2 * r.cpu > budget) break;
    }
    return std::nullopt;
  }
};

}  // namespace cylon::bench
