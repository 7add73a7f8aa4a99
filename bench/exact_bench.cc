// What one state of an exact solution costs: every solution that a scenario follows, by the scenario that it
// is followed in, at times that spread over the whole duration (no two alike, so that nothing is remembered),
// and what making it costs, its error bound included.  Target: under 20 us a state.
#include "harness/cli/context.h"
#include "harness/scenario/scenario.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>

namespace {

using namespace cylon;

void state_cost(benchmark::State& state, const scenario::Scenario& scenario, const core::Claim& claim) {
  const double step = std::min(claim.until, scenario.duration) / 1.6180339887498949;
  double t = 0;
  std::size_t bodies = 0;
  for (auto _ : state) {
    const core::State s = claim.truth->state(t);
    benchmark::DoNotOptimize(s.data());
    bodies = s.size();
    t += step;
    if (t > std::min(claim.until, scenario.duration)) t -= std::min(claim.until, scenario.duration);
  }
  state.counters["bodies"] = static_cast<double>(bodies);
  state.counters["error_m"] = claim.truth->error.position;
}

void load_cost(benchmark::State& state, const std::filesystem::path& file) {
  for (auto _ : state) benchmark::DoNotOptimize(scenario::load(file).claims.data());
}

}  // namespace

int main(int argc, char** argv) try {
  for (const std::filesystem::path& file : cli::scenario_files(cli::make_context())) {
    const auto scenario = std::make_shared<scenario::Scenario>(scenario::load(file));
    std::set<std::string> seen;
    for (const core::Claim& claim : scenario->claims) {
      if (!claim.truth || !claim.truth->times.empty() || !seen.insert(claim.follows).second) continue;
      const std::string name = fmt::format("{}/{}", claim.follows, scenario->name);
      benchmark::RegisterBenchmark(("state/" + name).c_str(), [scenario, &claim](benchmark::State& state) {
        state_cost(state, *scenario, claim);
      })->Unit(benchmark::kMicrosecond);
    }
    if (!seen.empty()) {
      benchmark::RegisterBenchmark(("load/" + scenario->name).c_str(), [file](benchmark::State& state) {
        load_cost(state, file);
      })->Unit(benchmark::kMillisecond);
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
} catch (const core::InputError& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 2;
}
