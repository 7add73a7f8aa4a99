// What the harness itself costs beside the engine that it records: everything that is not the engine's own
// stepping (spawn, scene, recording, frames, measuring, judging), as a share of it.  Target: under 5 % of
// ODE's stepping for 1000 free bodies over 5000 steps at the default sampling.  CPU time of this process and
// its worker, so that a loaded machine does not matter; the error beside it says that the run was a real one.
#include "bench/free_cloud.h"
#include "harness/cli/context.h"
#include "harness/study/cell.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <sys/resource.h>

#include <cmath>

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

{}
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
                     0.001 * static_cast<double>(steps),
                     bench::free_cloud(bodies, "[0.2, 0.3, 0.4]", "[0.3, 1.1, -0.4]"));
}

struct Cost {
  double engine = 0, all = 0;  // CPU [s]
  double error = 0;            // of the energy, as a share of what is allowed
  std::string failure;
};

Cost cost(const scenario::Scenario& scenario, const process::EngineChoice& engine) {
  const double start = cpu_seconds();
  const auto rows = study::run({&scenario, engine, scenario.step, scenario.step_text}, {}, {});
  const results::Verdict& row = rows.back();
  const bool recorded = std::isfinite(row.measured);
  return {row.cpu_seconds, cpu_seconds() - start, row.measured / row.allowed, recorded ? "" : row.detail};
}

void harness_cost(benchmark::State& state, const char* id) {
  const cli::Context context = cli::make_context();
  const process::EngineChoice engine = process::parse_engine(id, context.engines);
  const auto run = scenario::parse(free_bodies(state.range(0), state.range(1)), "free_bodies.toml");
  const auto one_step = scenario::parse(free_bodies(state.range(0), 1), "one_step.toml");
  double stepping = 0, recording = 0, setup = 0, error = 0;
  for (auto _ : state) {
    const Cost start = cost(one_step, engine), whole = cost(run, engine);
    if (!whole.failure.empty()) return state.SkipWithError(whole.failure.c_str());
    stepping += whole.engine;
    setup += start.all - start.engine;
    recording += (whole.all - whole.engine) - (start.all - start.engine);
    error = whole.error;
    state.SetIterationTime(whole.all);
  }
  const double runs = static_cast<double>(state.iterations()),
               steps = runs * static_cast<double>(state.range(1));
  state.counters["engine_us_per_step"] = 1e6 * stepping / steps;
  state.counters["recording_measuring_judging_%"] = 100 * recording / stepping;
  state.counters["with_spawn_and_load_%"] = 100 * (recording + setup) / stepping;
  state.counters["spawn_and_load_ms"] = 1e3 * setup / runs;
  state.counters["energy_error/allowed"] = error;
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
