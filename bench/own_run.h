// This engine on a smooth scene: the error and the cost of an integrator and a step, and the cheapest that
// reach an error.
#pragma once

#include "bench/cpu_time.h"
#include "bench/smooth_scenes.h"
#include "engine/make_stepper.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cylon::bench {

inline constexpr int samples = 4;  // at T/4, T/2, 3T/4 and T

struct Run {
  std::string how;
  double steps = 0, error = INFINITY, cpu = INFINITY;  // [s]
};

inline core::State state_of(const engine::Model& model, const std::vector<engine::Motion>& motions) {
  core::State state(motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    state[i].position = motions[i].position.cast<double>();
    state[i].orientation = motions[i].orientation.cast<double>();
    state[i].velocity = engine::velocity(model.bodies[i], motions[i]).cast<double>();
  }
  return state;
}

struct Subject {
  engine::Model model;
  double duration;
  Truth truth;
  Error error;
  std::vector<core::State> truths;

  std::unique_ptr<engine::Stepper> make(const engine::Options& options) const {
    return engine::make_stepper(model, options, engine::make_plan(model, options));
  }
  engine::Options options(const std::string& integrator, std::int64_t steps, double tolerance = 0) const {
    engine::Options o;
    o.integrator = integrator, o.dt = duration / static_cast<double>(steps);
    o.tolerance = static_cast<engine::Real>(tolerance);
    return o;
  }
  double error_of(const engine::Options& options, std::int64_t steps) const {
    const auto stepper = make(options);
    std::vector<engine::Motion> motions;
    double worst = 0;
    for (std::size_t k = 0; k < samples; ++k) {
      stepper->advance(steps / samples);
      stepper->read(motions);
      const double e = error(state_of(model, motions), truths[k]);
      worst = std::isfinite(e) ? std::max(worst, e) : INFINITY;
    }
    return worst;
  }
  // The smallest of `repeats` batches; a batch takes 0.2 ms and more.
  double cost(const engine::Options& options, std::int64_t steps, bool with_making, int repeats) const {
    double best = 1e30;
    std::size_t batch = 1;
    for (int r = 0; r < repeats; ++r) {
      std::vector<std::unique_ptr<engine::Stepper>> steppers(batch);
      std::vector<engine::Motion> motions(model.bodies.size());
      if (!with_making)
        for (auto& s : steppers) s = make(options);
      const double start = cpu_now();
      for (auto& s : steppers) {
        if (with_making) s = make(options);
        for (int k = 0; k < samples; ++k) {
          s->advance(steps / samples);
          s->read(motions);
        }
      }
      const double whole = cpu_now() - start;
      best = std::min(best, whole / static_cast<double>(batch));
      if (whole < 2e-4 && batch < 4096) batch *= 2, --r;
    }
    return best;
  }
};

inline constexpr const char* integrators[] = {"velocity-verlet", "bm4", "rkn4", "bm6", "rkn6", "rk4", "rk8"};

// The fewest steps of a ladder by which an integrator reaches an error, and keeps it.
inline std::optional<std::int64_t> fewest(const Subject& s, const char* integrator, double target) {
  const engine::Integrator& row = *engine::find_integrator(integrator);
  std::int64_t found = 0;
  int kept = 0;
  for (double n = 4 * samples; n < 4e6; n = std::max(n * 1.1, n + samples)) {
    const std::int64_t steps = samples * static_cast<std::int64_t>(n / samples);
    const double error = s.error_of(s.options(integrator, steps), steps);
    if (error <= target) {
      if (kept == 0) found = steps;
      if (++kept == 4) return found;
    } else {
      kept = 0;
      // a part of what the order says is missing
      n *= std::clamp(std::pow(error / target, 0.5 / row.order) / 1.1, 1.0, 2.0);
    }
    if (n * row.evaluations > 4e5) break;
  }
  return std::nullopt;
}

inline Run tuned(const Subject& s, double target) {
  Run best;
  for (const char* integrator : integrators) {
    const auto steps = fewest(s, integrator, target);
    if (!steps) continue;
    const auto o = s.options(integrator, *steps);
    const double cpu = s.cost(o, *steps, false, 15);
    if (cpu < best.cpu) best = {integrator, static_cast<double>(*steps), s.error_of(o, *steps), cpu};
  }
  return best;
}

}  // namespace cylon::bench
