// What a long history costs to read: 10 000 runs of 50 cells with four metrics, three samples of each time,
// in a store in a temporary folder.  Target: the list of runs and the series of one cell and metric in under
// 0.2 s together, each with the file opened anew.
#include "harness/tracking/store/store.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <stdlib.h>

#include <filesystem>
#include <limits>
#include <stdexcept>

namespace {

namespace fs = std::filesystem;
using namespace cylon::store;

constexpr int runs = 10'000, cells = 50, repetitions = 3;

Result result(int cell, int run) {
  Result r;
  r.cell.scenario = fmt::format("scenario_{}", cell / 5);
  r.cell.scenario_hash = "0123456789abcdef";
  r.cell.engine = fmt::format("engine_{}", cell % 5);
  r.cell.path = "rigid";
  r.cell.integrator = "semi-implicit-euler";
  r.cell.precision = "double";
  r.cell.dt = 0.001;
  r.cell.dt_text = "0.001";
  r.engine_version = "3.24";
  r.asked = fmt::format("{:016x}", 0x9e3779b97f4a7c15u * static_cast<unsigned>(cell + 1));
  const double drift = 1 + 1e-5 * run;
  for (int i = 0; i < repetitions; ++i)
    r.samples.push_back({{"cpu_seconds", Kind::time, "s"}, i, 0.01 * (cell + 1) * drift + 1e-5 * i, ""});
  r.samples.push_back({{"error:position follows it", Kind::error, "m"}, 0, 1e-6 * (cell + 1), ""});
  r.samples.push_back({{"peak_memory", Kind::size, "B"}, 0, 4.8e6 + 1e4 * cell, ""});
  r.samples.push_back(
      {{"state_hash", Kind::exact, ""}, 0, std::numeric_limits<double>::quiet_NaN(), r.asked});
  r.judgements.push_back({"position follows it", "position", "m", "pass", "pass", 1e-6, 1e-3, 1e-13, ""});
  return r;
}

// A folder with the store, made once and taken away at the end.
class Big {
 public:
  Big() {
    std::string name = (fs::temp_directory_path() / "cylon-bench-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    folder_ = name;
    Store store = Store::open(file(), Mode::write);
    for (int first = 0; first < runs; first += 100)
      store.in_one_transaction([&] {
        for (int run = first; run < first + 100; ++run) add(store, run);
      });
  }
  ~Big() { fs::remove_all(folder_); }
  Big(const Big&) = delete;
  Big& operator=(const Big&) = delete;

  fs::path file() const { return folder_ / "history.db"; }

 private:
  // As an import does it: begin_run() looks at all pages each time.
  static void add(Store& store, int run) {
    RunInfo info;
    info.revision = fmt::format("r{}", run);
    info.revision_order = run;
    info.date = "2024-05-01T00:00:00Z";
    info.machine = "a processor, 2 logical CPUs";
    info.complete = true;
    info.uid = run_uid(info, 0);
    std::int64_t id = 0;
    store.import_run(info, id);
    for (int cell = 0; cell < cells; ++cell) store.add(id, result(cell, run));
  }

  fs::path folder_;
};

const Big& big() {
  static const Big store;
  return store;
}

void list_of_runs(benchmark::State& state) {
  const fs::path file = big().file();
  std::size_t found = 0;
  for (auto _ : state) found = Store::open(file, Mode::read).runs().size();
  state.counters["runs"] = static_cast<double>(found);
  state.counters["file_MB"] = static_cast<double>(fs::file_size(file)) * 1e-6;
}
BENCHMARK(list_of_runs)->Unit(benchmark::kMillisecond);

void series_of_a_cell_and_metric(benchmark::State& state) {
  const fs::path file = big().file();
  std::size_t points = 0, samples = 0;
  for (auto _ : state) {
    const auto series = Store::open(file, Mode::read).series("scenario_7/engine_3@0.001", "cpu_seconds");
    points = series.at(0).points.size();
    samples = points * series.at(0).points.at(0).values.size();
  }
  state.counters["points"] = static_cast<double>(points);
  state.counters["samples"] = static_cast<double>(samples);
}
BENCHMARK(series_of_a_cell_and_metric)->Unit(benchmark::kMillisecond);

void results_of_a_run(benchmark::State& state) {
  const Store store = Store::open(big().file(), Mode::read);
  std::size_t found = 0;
  for (auto _ : state) found = store.results(runs / 2).size();
  state.counters["results"] = static_cast<double>(found);
}
BENCHMARK(results_of_a_run)->Unit(benchmark::kMillisecond);

// One cell of a run: a transaction of its own, on the disk when it returns.
void storing_a_cell(benchmark::State& state) {
  const fs::path file = big().file().string() + ".another";
  {
    Store store = Store::open(file, Mode::write);
    RunInfo run;
    run.revision = "r";
    std::int64_t id = store.begin_run(run);
    int cell = 0;
    for (auto _ : state) store.add(id, result(cell++, 0));
  }
  fs::remove(file);
}
BENCHMARK(storing_a_cell)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
