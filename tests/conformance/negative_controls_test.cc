// Negative controls: each engine with one known error must fail for this error, and must not stop the
// checks of the other engines.
#include "harness/study/cell_pool.h"
#include "tests/conformance/fixture.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace cylon::conformance {
namespace {

using results::Status;
using results::Verdict;

// Room for a machine under load; a run that never ends is given up after `run_seconds`.
process::Limits within(double run_seconds) { return {60, run_seconds, std::size_t{4} << 30}; }

std::vector<Verdict> judged(const scenario::Scenario& scenario, const process::EngineChoice& engine) {
  return study::run({&scenario, engine, scenario.step, scenario.step_text}, within(120), {});
}

const Verdict& row(const std::vector<Verdict>& rows, const std::string& claim) {
  for (const Verdict& one : rows)
    if (one.claim.starts_with(claim)) return one;
  throw std::out_of_range("no claim '" + claim + "'");
}

// ---- Without the gyroscopic term -------------------------------------------------------------------
// w is constant, so the
// body turns steadily about it and R^T w, hence the energy, is constant to the last digit; yet the body
// neither wobbles nor flips, and its angular momentum turns with it.

constexpr const char* without_gyro[] = {"bullet/gyro=none", "bullet-multibody/gyro=none", "ode/gyro=off",
                                        "ode-quick/gyro=off"};

TEST(WithoutTheGyroscopicTerm, EnergyIsConservedButMotionIsWrong) {
  for (const std::string scenario : {"free_symmetric_top", "dzhanibekov"})
    for (const char* id : without_gyro) {
      const std::vector<Verdict> rows = judged(shipped(scenario), engine(id));
      const Verdict& energy = row(rows, "energy conserved");
      EXPECT_EQ(energy.status, Status::pass) << scenario << ", " << id << ": " << energy.measured;
      EXPECT_GT(results::digits(energy.measured, energy.allowed), 5) << scenario << ", " << id;
      EXPECT_EQ(row(rows, "linear_momentum conserved").status, Status::pass) << scenario << ", " << id;
      const Verdict& orientation = row(rows, "orientation follows");
      EXPECT_EQ(orientation.status, Status::fail) << scenario << ", " << id << ": " << orientation.detail;
      EXPECT_GT(orientation.measured, 0.5) << "rad: not the same motion; " << scenario << ", " << id;
      EXPECT_NE(row(rows, "angular_momentum conserved").status, Status::pass) << scenario << ", " << id;
      EXPECT_EQ(orientation.gyroscopic, "none") << id;  // and the report says why
    }
}

TEST(WithoutTheGyroscopicTerm, TheHeavyTopFalls) {
  for (const char* id : without_gyro) {
    const std::vector<Verdict> rows = judged(shipped("heavy_top"), engine(id));
    for (const char* claim : {"axis follows", "position follows"}) {
      const Verdict& verdict = row(rows, claim);
      EXPECT_EQ(verdict.status, Status::fail) << id << ": " << verdict.measured;
      EXPECT_GT(verdict.measured, 0.1) << id << ", " << claim;  // m, rad
    }
  }
}

// ---- A user's engine that misbehaves ---------------------------------------------------------------

// Uniform motion for 100 steps, which tests/harness/process/scripted_worker.py can do.
const scenario::Scenario& drifting() {
  static const scenario::Scenario scenario = scenario::parse(R"(
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
follows    = "projectile"
observable = "position"
tolerance  = { absolute = 1e-9, reason = "rounding" }
[[claim]]
conserves  = "linear_momentum"
tolerance  = { absolute = 1e-9, reason = "rounding" }
)",
                                                             "drifting.toml");
  return scenario;
}

// As a user adds it: a command.
process::EngineChoice users_engine(const std::string& mode) {
  const process::EngineRow engine_row{
      "mine-" + mode, {"python3", source("tests/harness/process/scripted_worker.py").string(), mode}, ""};
  return process::parse_engine(engine_row.id, std::vector{engine_row});
}

struct Impostor {
  const char* mode;
  Status status;           // of the claim on position
  Status momentum_status;  // of the claim on momentum, which reads velocities alone
  const char* detail;
};

constexpr Impostor impostors[] = {
    {"good", Status::pass, Status::pass, ""},
    {"nan", Status::non_finite, Status::non_finite, ""},
    {"nonsense", Status::fail, Status::pass, ""},
    {"abort_in_run", Status::crash, Status::crash, "killed by SIGABRT: Assertion 'mass > 0' failed"},
    {"exit_0_in_run", Status::crash, Status::crash, "exited 0 before done"},
    {"error_in_run", Status::crash, Status::crash, "stopped after step 50: Jacobian is singular"},
    {"loop_in_run", Status::timeout, Status::timeout, "'run' did not end within 3 s"},
    {"garbage_in_run", Status::protocol, Status::protocol, "Warning: friction too high"},
    {"backward", Status::protocol, Status::protocol, "where step"},
    {"wrong_start", Status::fail, Status::fail, "initial state read back differs: body 'rock' position"},
    {"unsupported", Status::unsupported, Status::unsupported, "no bodies at all"},
};

// One matrix with good engines among the bad ones, on two workers: each gets its own verdict, in the order of
// the cells.
TEST(Impostors, EachIsDetectedAndTheRunContinues) {
  std::vector<study::Cell> cells;
  const auto add = [&](const process::EngineChoice& choice) {
    cells.push_back({&drifting(), choice, drifting().step, drifting().step_text});
  };
  add(engine("in-house"));
  for (const Impostor& impostor : impostors) add(users_engine(impostor.mode));
  add(engine("ode"));

  std::size_t reported = 0;
  const auto rows =
      study::run(cells, {2, within(3)}, {}, [&](std::size_t, const std::vector<Verdict>&, double) {
        ++reported;
      }).rows;
  ASSERT_EQ(rows.size(), cells.size());
  EXPECT_EQ(reported, cells.size());
  for (const std::size_t good : {std::size_t{0}, cells.size() - 1})
    for (const Verdict& verdict : rows[good])
      EXPECT_EQ(results::name(verdict.status), "pass")
          << verdict.engine << ", " << verdict.claim << ": " << verdict.detail;

  for (std::size_t i = 0; i < std::size(impostors); ++i) {
    const Impostor& impostor = impostors[i];
    const Verdict &position = row(rows[i + 1], "position follows"),
                  &momentum = row(rows[i + 1], "linear_momentum");
    EXPECT_EQ(position.engine, std::string("mine-") + impostor.mode);
    EXPECT_EQ(results::name(position.status), results::name(impostor.status))
        << impostor.mode << ": " << position.detail;
    EXPECT_EQ(results::name(momentum.status), results::name(impostor.momentum_status)) << impostor.mode;
    EXPECT_NE(position.detail.find(impostor.detail), std::string::npos)
        << impostor.mode << ": " << position.detail;
    if (impostor.status == Status::non_finite)
      EXPECT_EQ(position.first_bad_step, 51) << impostor.mode;  // of 100: junk after step 50
    else
      EXPECT_FALSE(position.first_bad_step) << impostor.mode;
  }
}

}  // namespace
}  // namespace cylon::conformance
