#include "harness/tracking/track_times.h"

#include "harness/results/build.h"
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

// Why the times of an engine and of an anchor do not compare; empty where they do.
std::string no_ratio(const study::Sample& own, const study::Sample& anchor) {
  if (!anchor.failure.empty()) return anchor.failure;
  const std::string build = results::build_in_words(own.version),
                    other = results::build_in_words(anchor.version);
  return build == other ? "" : fmt::format("{}, and the anchor is {}: costs do not compare", build, other);
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
    std::vector<study::Sample> of_anchors(anchors.size());
    const auto take_anchors = [&] {
      for (std::size_t k = 0; k < anchors.size(); ++k)
        of_anchors[k] = take(study::pinned(in_place_of(cell.engine, anchors[k]), pinning));
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
    for (std::size_t k = 0; k < anchors.size(); ++k) {
      const study::Sample& anchor = of_anchors[k];
      if (const std::string why = no_ratio(own, anchor); !why.empty())
        samples.push_back({{"no_ratio:" + anchors[k].name, store::Kind::info, ""}, i, nan, why});
      else
        samples.push_back({{"cpu_ratio:" + anchors[k].name, store::Kind::time, "ratio"},
                           i,
                           own.seconds / anchor.seconds,
                           ""});
    }
  }
  return samples;
}

}  // namespace cylon::tracking
