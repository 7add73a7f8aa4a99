#include "harness/tracking/track_times.h"

#include "harness/study/paired_times.h"
#include "harness/study/sampler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::tracking {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double least_seconds = 1e-3;   // of what is timed at once: shorter runs are summed [s]
constexpr double process_seconds = 0.1;  // that the repetitions of one process may take [s]
constexpr int most_runs = 250, most_repetitions = 8;

// The whole duration always, so that times of different days are times of the same work.
study::SamplePlan plan_of(const study::Cell& cell, const process::RunOutcome& first) {
  const double run = std::max(first.recording->cpu_seconds, 1e-9);
  study::SamplePlan plan;
  plan.scene = &cell.scenario->scene;
  plan.dt = cell.dt;
  plan.steps = plan.of = study::sampling(*cell.scenario, cell.dt).steps;
  plan.runs = static_cast<int>(std::clamp(std::ceil(least_seconds / run), 1.0, double{most_runs}));
  plan.repetitions =
      static_cast<int>(std::clamp(process_seconds / (run * plan.runs), 1.0, double{most_repetitions}));
  plan.with_load = core::controls_its_error(first.engine, first.terms);
  return plan;
}

}  // namespace

std::vector<store::Sample> time_samples(const study::Cell& cell, const process::RunOutcome& first, int count,
                                        const std::vector<PinnedEngine>& anchors,
                                        const process::Limits& limits) {
  std::vector<store::Sample> samples;
  const study::SamplePlan plan = plan_of(cell, first);
  const study::Pinning& pinning = study::pin_to_one_processor();
  const process::EngineChoice engine = study::pinned(cell.engine, pinning);
  const auto take = [&](const process::EngineChoice& choice) {
    return study::take_sample(choice, plan, limits);
  };
  for (int i = 0; i < count; ++i) {
    std::vector<double> pinned_seconds(anchors.size(), nan);
    const auto take_anchors = [&] {
      for (std::size_t k = 0; k < anchors.size(); ++k) {
        const study::Sample s = take(study::pinned(in_place_of(cell.engine, anchors[k]), pinning));
        if (s.failure.empty()) pinned_seconds[k] = s.seconds;
      }
    };
    const bool anchors_first = study::first_goes_first(i);
    if (anchors_first) take_anchors();
    const study::Sample own = take(engine);
    if (!anchors_first) take_anchors();
    if (!own.failure.empty()) {
      samples.push_back({{"no_time", store::Kind::info, ""}, i, nan, own.failure});
      continue;
    }
    samples.push_back({{"cpu_seconds", store::Kind::time, "s"}, i, own.seconds, ""});
    for (std::size_t k = 0; k < anchors.size(); ++k)
      if (!std::isnan(pinned_seconds[k]))
        samples.push_back({{"cpu_ratio:" + anchors[k].name, store::Kind::time, "ratio"},
                           i,
                           own.seconds / pinned_seconds[k],
                           ""});
  }
  return samples;
}

}  // namespace cylon::tracking
