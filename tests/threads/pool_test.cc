// The pool of cells and its jobs, on more threads than the machine has processors: engines that are well, engines
// that are not, an interruption, and an end by exception.
#include "harness/core/input_error.h"
#include "harness/process/interruption.h"
#include "harness/study/cell_pool.h"
#include "harness/study/parallel.h"
#include "tests/harness/process/fixture.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace cylon::study {
namespace {

using results::Status;

constexpr int workers = 4;
const process::Limits limits = {300, 300, std::size_t{4} << 30};

// Body names as scripted_worker.py knows none; it moves all uniformly.
const scenario::Scenario& drifting() {
  static const scenario::Scenario scene = scenario::parse(R"(duration = 1
step = 0.01
[[body]]
name = "a"
mass = 1.5
position = [0.3, -0.2, 0.7]
velocity = [1.25, -0.5, 0.125]
[[claim]]
conserves = "linear_momentum"
tolerance = { absolute = 1e-9, reason = "rounding" }
)",
                                                          "drifting.toml");
  return scene;
}

process::EngineChoice built(const std::string& id) {
  return process::parse_engine(id, process::default_engines(binary_dir));
}

std::vector<Cell> cells_of(const std::vector<process::EngineChoice>& engines) {
  std::vector<Cell> cells;
  for (const process::EngineChoice& engine : engines)
    cells.push_back({&drifting(), engine, drifting().step, drifting().step_text});
  return cells;
}

std::vector<process::EngineChoice> mixed() {
  std::vector<process::EngineChoice> engines;
  for (int i = 0; i < 4; ++i)
    for (const process::EngineChoice& engine :
         {built("in-house"), process::scripted("good"), process::scripted("abort_in_run"),
          process::scripted("stray_in_run"), built("in-house/path=steps")})
      engines.push_back(engine);
  return engines;
}

TEST(Pool, RowsAreThoseOfOneThread) {
  const std::vector<Cell> cells = cells_of(mixed());
  const auto statuses = [&](int threads) {
    std::size_t told = 0;
    const Matrix matrix =
        run(cells, {threads, limits}, {}, [&](std::size_t, const auto&, double) { ++told; });
    EXPECT_EQ(told, cells.size());
    std::vector<std::string> result;
    for (const auto& rows : matrix.rows)
      for (const results::Verdict& row : rows) result.emplace_back(results::name(row.status));
    return result;
  };
  const auto expected = statuses(1);
  EXPECT_EQ(expected.size(), cells.size());
  EXPECT_EQ(statuses(workers), expected);
}

TEST(Pool, IsInterrupted) {
  const std::vector<Cell> cells =
      cells_of({built("in-house"), process::scripted("loop_in_run"), process::scripted("loop_in_load"),
                process::scripted("loop_in_hello"), process::scripted("good")});
  const Matrix matrix = run(cells, {workers, limits}, {}, [&](std::size_t, const auto&, double) {
    process::interrupted() = true;  // the loops run, or have not begun
  });
  process::interrupted() = false;
  EXPECT_TRUE(matrix.interrupted);
  EXPECT_TRUE(matrix.rows[1].empty() && matrix.rows[2].empty() && matrix.rows[3].empty());
  EXPECT_FALSE(process::has_children());
}

TEST(Pool, EndsByWhatItsReporterThrows) {
  int told = 0;
  EXPECT_THROW(run(cells_of(mixed()), {workers, limits}, {},
                   [&](std::size_t, const auto&, double) {
                     if (++told == 3) throw core::InputError("the disk is full");
                   }),
               core::InputError);
  EXPECT_EQ(told, 3);
}

TEST(Jobs, RunOnceEachAndThrowTheFirstError) {
  constexpr std::size_t count = 1000;
  std::vector<int> done(count);
  in_parallel(count, workers, [&](std::size_t i) { ++done[i]; });
  EXPECT_EQ(done, std::vector<int>(count, 1));
  std::atomic<std::size_t> begun = 0;
  const auto fails = [&](std::size_t i) {
    ++begun;
    if (i >= 10) throw std::runtime_error(std::to_string(i));
  };
  EXPECT_THROW(in_parallel(count, workers, fails), std::runtime_error);
  EXPECT_LT(begun, count);
}

}  // namespace
}  // namespace cylon::study
