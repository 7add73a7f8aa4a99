// An engine whose positions turned to NaN after step 50 passed "linear_momentum conserved", because that
// claim reads velocities alone and they stayed finite; its row said pass and first_bad_step at once.  A run
// that breaks within a claim's horizon now is non-finite for it, whatever the claim reads; a claim whose
// horizon ends before is judged as ever.
#include "harness/study/cell.h"
#include "harness/study/metamorphic.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::study {
namespace {

scenario::Scenario drifting() {
  return scenario::parse(R"(
title    = "Nothing acts"
story    = "A body drifts."
duration = 1.0
step     = 0.01
[[body]]
name     = "rock"
mass     = 1.7
inertia  = [0.3, 0.3, 0.3]
position = [0.3, -1.2, 2.5]
velocity = [1.25, -0.5, 0.7]
[[claim]]
conserves = "linear_momentum"
tolerance = { absolute = 1e-9, reason = "rounding" }
[[claim]]
conserves = "energy"
until     = 0.5
tolerance = { absolute = 1e-9, reason = "rounding" }
)",
                         "drifting.toml");
}

process::EngineChoice turns_to_nan() {
  const std::string script = std::string(source_dir) + "/tests/harness/process/scripted_worker.py";
  return {"mine", {"mine", {"python3", script, "nan"}, ""}, "", "", {}};
}

TEST(BrokenRun, FailsAllClaimsWithinHorizon) {
  const scenario::Scenario scenario = drifting();
  const auto rows = run({&scenario, turns_to_nan(), 0.01, "0.01"}, {60, 60, 0}, {});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(results::name(rows[0].status), "non-finite") << rows[0].claim;
  EXPECT_EQ(rows[0].first_bad_step, 51);
  EXPECT_TRUE(std::isnan(rows[0].measured));
  EXPECT_EQ(results::name(rows[1].status), "pass") << rows[1].claim;
}

// No scene begins with such a state: the reader of the worker refused the run back in time, and ended the whole hunt.
TEST(BrokenRun, KeepsNoRelation) {
  const scenario::Scenario scenario = drifting();
  const auto rows = relate({&scenario, turns_to_nan(), 0.01, "0.01"}, {60, 60, 0}, {});
  ASSERT_GE(rows.size(), 10u);
  for (const results::Verdict& row : rows) {
    EXPECT_EQ(results::name(row.status), "non-finite") << row.claim;
    EXPECT_EQ(row.first_bad_step, 51) << row.claim;
  }
}

}  // namespace
}  // namespace cylon::study
