// An optional engine that takes too long, or too much memory, is a verdict; the next run of it is as ever.
#include "harness/process/engine_table.h"
#include "tests/conformance/fixture.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

namespace cylon::conformance {
namespace {

TEST(OptionalEngines, AreHeldToTimeAndMemory) {
  const core::Scene scene = shipped("projectile").scene;
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = 1e-3;
  int asked = 0;
  for (const process::EngineRow& row : process::default_engines(binary_dir)) {
    if (!row.optional() || process::missing(row)) continue;
    const process::EngineChoice choice = engine(row.id);
    const auto outcome = [&](std::int64_t steps, const process::Limits& limits) {
      request.steps = request.every = steps;
      return process::run(choice, request, limits);
    };
    constexpr std::int64_t for_hours = std::int64_t{1} << 40;
    const auto slow = outcome(for_hours, {.run_seconds = 0.3});
    EXPECT_EQ(slow.status, results::Status::timeout) << row.id << ": " << slow.reason;
    const auto large = outcome(for_hours, {.run_seconds = 60, .memory_bytes = std::size_t{1} << 20});
    EXPECT_FALSE(large.recording || large.reason.empty()) << row.id;  // some do not even start
    const auto as_ever = outcome(10, {});
    EXPECT_TRUE(as_ever.recording) << row.id << ": " << as_ever.reason;
    ++asked;
  }
  if (asked == 0) GTEST_SKIP() << "none is here; `./run engines` brings them";
}

}  // namespace
}  // namespace cylon::conformance
