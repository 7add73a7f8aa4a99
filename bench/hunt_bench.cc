// How many random scenes a second `cylon hunt` asks of an engine, on one core: all oracles, all steps, hits seen again.  CPU
// time of this process and its workers, so that a loaded machine does not matter.  Beside it the runs that end in a fault
// (a right engine has none), and of the first fault how long its scene takes to shrink.  Target: 120 s for a card.
#include "harness/cli/context.h"
#include "harness/hunt/hunt.h"

#include <benchmark/benchmark.h>

#include <sys/resource.h>

namespace {

using namespace cylon;

constexpr std::uint64_t scenes = 100;

double cpu_seconds(int who) {
  rusage usage{};
  getrusage(who, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double cpu_seconds() { return cpu_seconds(RUSAGE_SELF) + cpu_seconds(RUSAGE_CHILDREN); }

void hunted(benchmark::State& state, const char* id) {
  const cli::Context context = cli::make_context();
  const hunt::Quarry quarry{process::parse_engine(id, context.engines), {.run_seconds = 20}, 1, nullptr};
  const hunt::Source source(1);
  double searching = 0, shrinking = 0, cards = 0;
  std::size_t hits = 0;
  for (auto _ : state) {
    const double start = cpu_seconds();
    const hunt::Found found =
        hunt::search(source, 0, quarry, [](std::uint64_t begun) { return begun < scenes; });
    const double middle = cpu_seconds();
    const auto made = hunt::cards(source, found.hits, quarry, {}, {});
    searching += middle - start, shrinking += cpu_seconds() - middle;
    hits += found.hits.size(), cards += static_cast<double>(made.size());
    state.SetIterationTime(middle - start);
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["scenes_per_second"] = runs * static_cast<double>(scenes) / searching;
  state.counters["scenes_with_a_fault"] = static_cast<double>(hits) / runs;
  state.counters["cards"] = cards / runs;
  state.counters["shrinking_s_per_card"] = cards > 0 ? shrinking / cards : 0;
}

BENCHMARK_CAPTURE(hunted, in_house, "in-house")->Iterations(1)->UseManualTime()->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(hunted, ode, "ode")->Iterations(1)->UseManualTime()->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(hunted, bullet, "bullet")->Iterations(1)->UseManualTime()->Unit(benchmark::kSecond);

}  // namespace

BENCHMARK_MAIN();
