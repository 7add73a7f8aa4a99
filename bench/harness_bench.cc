// What the harness itself costs beside the engine that it records: everything that is not the engine's own
// stepping (spawn, scene, recording, frames, measuring, judging), as a share of it.  Target: under 5 % of
// ODE's stepping for 1000 free bodies over 5000 steps at the default sampling.  CPU time of this process and
// its worker, so that a loaded machine does not matter; the error beside it says that the run was a real one.
#include "harness/cli/context.h"
#include "harness/study/cell.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <sys/resource.h>

#include <limits>

namespace {

using namespace cylon;

double cpu_seconds(int who) {
  rusage usage{};
  getrusage(who, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double cpu_seconds() { return cpu_seconds(RUSAGE_SELF) + cpu_seconds(RUSAGE_CHILDREN); }

// Spinning bodies that fly freely and never meet.
std::string free_bodies(std::int64_t bodies, std::int64_t steps) {
  return fmt::format(R"(
title = "Free bodies"
story = "Spinning boxes fly freely; the harness watches momentum, angular momentum and energy."
duration = {}
step = 0.001

[[cloud]]
name = "body"
seed = 1
count = {}
low = [-50, -50, -50]
high = [50, 50, 50]
speed = 1.0
mass = 1.5
inertia = [0.2, 0.3, 0.4]
angular_velocity = [0.3, 1.1, -0.4]

[[claim]]
conserves = "linear_momentum"
tolerance = {{ absolute = 1e-6, reason = "rounding" }}
[[claim]]
conserves = "angular_momentum"
tolerance = {{ relative = 1e-2, reason = "truncation" }}
[[claim]]
conserves = "energy"
tolerance = {{ relative = 1e-2, reason = "truncation" }}
)",
                     0.001 * static_cast<double>(steps), bodies);
}

void harness_cost(benchmark::State& state, const char* engine) {
  const cli::Context context = cli::make_context();
  const scenarios::Scenario scenario =
      scenarios::parse(free_bodies(state.range(0), state.range(1)), "free_bodies.toml");
  const study::Cell cell{&scenario, process::parse_engine(engine, context.engines), scenario.step,
                         scenario.step_text};
  double stepping = 0, harness = 0, least = std::numeric_limits<double>::infinity(), error = 0;
  for (auto _ : state) {
    const double start = cpu_seconds();
    const auto rows = study::run(cell, {}, {});
    const double all = cpu_seconds() - start;
    if (rows.front().status != core::Status::pass) return state.SkipWithError(rows.front().detail.c_str());
    stepping += rows.front().cpu_seconds;
    harness += all - rows.front().cpu_seconds;
    least = std::min(least, (all - rows.front().cpu_seconds) / rows.front().cpu_seconds);
    error = rows.back().measured / rows.back().allowed;
    state.SetIterationTime(all);
  }
  const double steps = static_cast<double>(state.iterations() * state.range(1));
  state.counters["engine_us_per_step"] = 1e6 * stepping / steps;
  state.counters["harness_us_per_step"] = 1e6 * harness / steps;
  state.counters["harness_percent"] = 100 * harness / stepping;
  state.counters["least_percent"] = 100 * least;
  state.counters["energy_error_of_allowed"] = error;
}

BENCHMARK_CAPTURE(harness_cost, ode, "ode")
    ->Args({1000, 5000})
    ->Args({1000, 20000})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(3);
BENCHMARK_CAPTURE(harness_cost, bullet, "bullet")
    ->Args({1000, 5000})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(harness_cost, in_house, "in-house")
    ->Args({1000, 5000})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(3);

}  // namespace

BENCHMARK_MAIN();
