// The observed order of the in-house engine's integrators on scenes with exact solutions, over the worker
// path:
// the slope of log(error) over log(dt) at dt, dt/2, dt/4.  Horizons and steps are such that the leading term
// of the error outweighs the next by thirty times or more and the smallest error stands above rounding.
#include "tests/conformance/fixture.h"

#include "harness/core/measure.h"
#include "harness/core/observable.h"
#include "harness/process/client.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <vector>

namespace cylon::conformance {
namespace {

constexpr double reach = 0.1;  // how far the slope may be from the order

struct Row {
  const char* scenario;
  core::Quantity quantity;
  double horizon;  // [s]
  const char* integrator;
  double dt;  // [s], the largest of three
  int order;
};
void PrintTo(const Row& row, std::ostream* out) { *out << row.scenario << " by " << row.integrator; }

std::string test_name(const std::string& scenario, const std::string& integrator) {
  std::string name = scenario + "_by_" + integrator;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

scenario::Scenario cut(const std::string& name, core::Quantity quantity, core::Reduction reduction,
                       double horizon) {
  scenario::Scenario scenario = shipped(name);
  scenario.duration = horizon;
  scenario.claims = {follows(scenario, quantity, reduction, 0)};
  return scenario;
}

std::string by(const std::string& integrator) { return "in-house/integrator=" + integrator; }

using enum core::Quantity;

const Row smooth[] = {
    {"spring_zero_length", position, 2, "explicit-euler", 1e-4, 1},
    {"spring_zero_length", position, 2, "lie-trotter", 1e-4, 1},
    {"spring_zero_length", position, 2, "velocity-verlet", 1e-2, 2},
    {"spring_zero_length", position, 2, "rk4", 1e-2, 4},
    {"spring_orbit", position, 2, "explicit-euler", 1e-4, 1},
    {"spring_orbit", position, 2, "lie-trotter", 1e-4, 1},
    {"spring_orbit", position, 2, "velocity-verlet", 1e-2, 2},
    {"spring_orbit", position, 2, "rk4", 1e-2, 4},
    {"spring_orbit", position, 2, "yoshida4", 1e-2, 4},
    {"spring_orbit", position, 2, "bm4", 2e-2, 4},
    {"spring_orbit", position, 2, "rkn4", 2e-2, 4},
    {"projectile", position, 0.8, "explicit-euler", 0.01, 1},
    {"projectile", position, 0.8, "lie-trotter", 0.01, 1},
    {"free_symmetric_top", orientation, 2, "explicit-euler", 1e-4, 1},
    {"free_symmetric_top", orientation, 2, "rk4", 1e-2, 4},
    {"dzhanibekov", orientation, 2, "explicit-euler", 1e-4, 1},
    {"dzhanibekov", orientation, 2, "rk4", 1e-2, 4},
    {"heavy_top", axis, 0.1, "explicit-euler", 1e-5, 1},
    {"heavy_top", axis, 0.1, "lie-trotter", 1e-5, 1},
    {"heavy_top", axis, 0.1, "velocity-verlet", 1e-3, 2},
    {"heavy_top", axis, 0.4, "rk4", 4e-3, 4},
};

class Order : public testing::TestWithParam<Row> {};

TEST_P(Order, IsTheDeclaredOne) {
  const Row& row = GetParam();
  const auto scenario = cut(row.scenario, row.quantity, core::Reduction::order, row.horizon);
  const results::Verdict verdict = conformance::verdict(scenario, by(row.integrator), row.dt);
  // measure() takes the slope only above the rounding floor, and says so.
  ASSERT_TRUE(verdict.detail.starts_with("observed order")) << verdict.detail;
  EXPECT_TRUE(verdict.detail.ends_with("declared " + std::to_string(row.order))) << verdict.detail;
  EXPECT_LE(verdict.measured, reach) << verdict.detail;
  RecordProperty("observed", verdict.detail);
}

INSTANTIATE_TEST_SUITE_P(InHouse, Order, testing::ValuesIn(smooth),
                         [](const auto& row) { return test_name(row.param.scenario, row.param.integrator); });

// Where an integrator is exact there is no slope, only rounding, at any step.
struct Exact {
  const char* scenario;
  core::Quantity quantity;
  double horizon;  // [s]
  const char* integrator;
  double dt;        // [s]
  double rounding;  // [unit]
};
void PrintTo(const Exact& row, std::ostream* out) { *out << row.scenario << " by " << row.integrator; }

const Exact exact[] = {
    // A parabola is what both integrate without error; a few eps of 4 m.
    {"projectile", position, 0.8, "velocity-verlet", 0.1, 1e-14},
    {"projectile", position, 0.8, "rk4", 0.1, 1e-14},
    // The splitting's two rotations commute for a symmetric body: 200 rad of precession, eps each.
    {"free_symmetric_top", orientation, 20, "lie-trotter", 0.1, 1e-12},
    {"free_symmetric_top", orientation, 20, "velocity-verlet", 0.1, 1e-12},
};

class Exactness : public testing::TestWithParam<Exact> {};

TEST_P(Exactness, LeavesRoundingOnly) {
  const Exact& row = GetParam();
  const auto scenario = cut(row.scenario, row.quantity, core::Reduction::max, row.horizon);
  EXPECT_LE(verdict(scenario, by(row.integrator), row.dt).measured, row.rounding);
  // The scene is no trivial one: explicit Euler fails it by far.
  EXPECT_GT(verdict(scenario, by("explicit-euler"), row.dt).measured, 1e6 * row.rounding);
}

INSTANTIATE_TEST_SUITE_P(InHouse, Exactness, testing::ValuesIn(exact),
                         [](const auto& row) { return test_name(row.param.scenario, row.param.integrator); });

// Negative control: the same runs with the declared order raised by one are called broken.
TEST(OrderMeasure, DetectsFalselyDeclaredOrder) {
  auto scenario = cut("spring_orbit", position, core::Reduction::max, 2);
  core::Claim& claim = scenario.claims[0];
  claim.tolerance = {.order = true, .constant = 1e6, .reason = "wide, so that the order alone decides"};
  std::vector<core::Recording> runs;
  for (const double dt : {1e-2, 5e-3, 2.5e-3}) {
    process::RunRequest request;
    request.scene = &scenario.scene;
    request.setup.dt = dt;
    request.steps = core::whole_steps(scenario.duration, dt);
    process::RunOutcome outcome = process::run(engine(by("velocity-verlet")), request);
    ASSERT_TRUE(outcome.recording) << outcome.reason;
    runs.push_back(std::move(*outcome.recording));
  }
  ASSERT_EQ(core::runs_needed(claim), 3);
  EXPECT_FALSE(core::measure(claim, scenario.scene, runs, scenario.duration).broken);
  for (core::Recording& run : runs) ++run.terms.order;
  const core::Measured boast = core::measure(claim, scenario.scene, runs, scenario.duration);
  EXPECT_TRUE(boast.broken) << boast.detail;
  EXPECT_LE(boast.value, boast.allowed) << "the order alone decides";
}

}  // namespace
}  // namespace cylon::conformance
