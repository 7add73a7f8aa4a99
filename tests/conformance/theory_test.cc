// Tolerances from theory, end to end: one claim C_p dt^p T with constants by order judges every integrator
// of the in-house engine, value and order.  Each constant is the leading term of its integrator's error, so
// what is measured comes close to what is allowed; with half the constant the same run fails.
#include "tests/conformance/fixture.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>

namespace cylon::conformance {
namespace {

using std::numbers::pi;

// ---- Scenes --------------------------------------------------------------------------------------

// Thrown upward: x(t) is a parabola.  Euler's integrators err by g T dt/2 at any step; order 2 and up is
// exact.
scenario::Scenario projectile(const std::string& tolerance) {
  return scenario::parse(fmt::format(R"(
title = "Thrown"
story = "A stone."
duration = 1.0
step = 0.01
gravity = [0, -9.81, 0]
[[body]]
name = "stone"
mass = 1.7
position = [0.3, -1.2, 2.5]
velocity = [1.25, 3.5, 0.7]
[[claim]]
follows = "projectile"
observable = "position"
tolerance = {}
)",
                                     tolerance),
                         "theory_projectile.toml");
}

// x = A cos(w t), A = 1.3 m, w = 2.5 rad/s, let go at rest; T = 2.25 periods, where the phase's error shows
// whole.
constexpr double amplitude = 1.3, w = 2.5;
scenario::Scenario spring(const std::string& tolerance) {
  return scenario::parse(fmt::format(R"(
title = "Spring"
story = "Back and forth."
duration = {:.17g}
step = {:.17g}
[[body]]
name = "weight"
mass = 2
position = [1.3, 0, 0]
[[spring]]
body = "weight"
pin = [0, 0, 0]
stiffness = 12.5
[[claim]]
follows = "spring_zero_length"
observable = "position"
sample = "step"
tolerance = {}
)",
                                     4.5 * pi / w, 4.5 * pi / w / 1000, tolerance),
                         "theory_spring.toml");
}

// Turns by 3 rad/s about its principal axis y, for ever.
constexpr double spin = 3;
scenario::Scenario top(const std::string& tolerance) {
  return scenario::parse(fmt::format(R"(
title = "Top"
story = "It turns."
duration = 10.0
step = 0.01
[[body]]
name = "top"
mass = 1
inertia = [0.3, 0.5, 0.4]
angular_velocity = [0, 3, 0]
[[claim]]
follows = "free_asymmetric_top"
observable = "orientation"
tolerance = {}
)",
                                     tolerance),
                         "theory_top.toml");
}

// ---- Constants -----------------------------------------------------------------------------------

struct Row {
  const char* what;
  scenario::Scenario (*scene)(const std::string& tolerance);
  const char* integrator;
  int order;
  double constant;  // of theory
  double steps;     // over the duration
  double least;     // measured / allowed comes at least so close; 0: the integrator is exact here
};
void PrintTo(const Row& row, std::ostream* out) { *out << row.what << " by " << row.integrator; }

const Row rows[] = {
    // v is late or early by g dt, on the average half of it: |error| = g t dt/2.
    {"projectile", projectile, "explicit-euler", 1, 9.81 / 2, 50, 0.99},
    {"projectile", projectile, "lie-trotter", 1, 9.81 / 2, 50, 0.99},
    {"projectile", projectile, "velocity-verlet", 2, 1, 50, 0},
    {"projectile", projectile, "rk4", 4, 1, 50, 0},
    // x'' = -w^2 x turns z = x + i v/w by a factor per step; with h = w dt,
    //   explicit Euler: |1 + i h|^n = exp(n h^2/2): grows by A w^2 T dt/2, last seen at 2 of 2.25 periods;
    //   velocity Verlet: cos(h') = 1 - h^2/2, h' = h (1 + h^2/24): ahead by A w^3 T dt^2/24;
    //   RK4: exp(i h) without its term (i h)^5/120: behind by A w^5 T dt^4/120;
    //   Lie-Trotter: the same angle h' as Verlet, half a step beside it: A w dt/2 at most, whatever T.
    {"spring", spring, "explicit-euler", 1, amplitude* w* w / 2, 2e4, 0.88},
    {"spring", spring, "lie-trotter", 1, amplitude / (9 * pi) * w* w, 4e3, 0.9},
    {"spring", spring, "velocity-verlet", 2, amplitude* w* w* w / 24, 1e3, 0.9},
    {"spring", spring, "rk4", 4, amplitude* std::pow(w, 5) / 120, 400, 0.9},
    // q' = w q/2: RK4 leaves out (i w dt/2)^5/120 of the half angle, so the angle is behind by w^5 T
    // dt^4/1920.
    {"top", top, "rk4", 4, std::pow(spin, 5) / 1920, 200, 0.9},
    {"top", top, "lie-trotter", 1, 1, 100, 0},
    {"top", top, "velocity-verlet", 2, 1, 100, 0},
};

std::string constants(double factor, const Row& row) {
  return fmt::format("{{ order = true, constants = {{ {} = {:.17g} }}, reason = \"truncation: theory\" }}",
                     row.order, factor * row.constant);
}

results::Verdict judged(const Row& row, double factor, const std::string& engine_id) {
  const auto scenario = row.scene(constants(factor, row));
  return verdict(scenario, engine_id, scenario.duration / row.steps);
}

class Theory : public testing::TestWithParam<Row> {};

TEST_P(Theory, BoundsTheErrorClosely) {
  const Row& row = GetParam();
  const std::string engine_id = std::string("in-house/integrator=") + row.integrator;
  const results::Verdict whole = judged(row, 1.02, engine_id);  // two hundredths for the terms that follow
  EXPECT_EQ(results::name(whole.status), "pass")
      << whole.measured << " of " << whole.allowed << "; " << whole.detail;
  RecordProperty("detail", whole.detail);
  if (row.least == 0) {
    EXPECT_NE(whole.detail.find("at the rounding floor"), std::string::npos) << whole.detail;
    return;
  }
  EXPECT_GT(whole.measured, row.least * whole.allowed / 1.02);
  EXPECT_NE(whole.detail.find("observed order"), std::string::npos) << whole.detail;
  EXPECT_NE(results::name(judged(row, 0.5, engine_id).status), "pass") << "half the constant";
}

INSTANTIATE_TEST_SUITE_P(InHouse, Theory, testing::ValuesIn(rows), [](const auto& row) {
  std::string name = std::string(row.param.what) + "_" + row.param.integrator;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// One claim for all: each integrator is held to the constant of its own order, or of the highest below; an
// integrator that chooses its own steps to the last, by its value alone.
TEST(TheoryClaim, ServesIntegratorsOfDifferentOrders) {
  const auto scenario =
      spring(fmt::format("{{ order = true, constants = {{ 1 = {:.17g}, 2 = {:.17g}, 4 = {:.17g} }}, reason = "
                         "\"truncation: theory\" }}",
                         1.02 * amplitude * w * w / 2, 1.02 * amplitude * w * w * w / 24,
                         1.02 * amplitude * std::pow(w, 5) / 120));
  struct Case {
    const char* engine;
    double steps;  // such that the leading term rules, above rounding
    const char* detail;
  };
  for (const Case& row : {Case{"in-house/integrator=explicit-euler", 1e4, "declared 1"},
                          Case{"in-house/integrator=lie-trotter", 1e4, "declared 1"},
                          Case{"in-house/integrator=velocity-verlet", 1e3, "declared 2"},
                          Case{"in-house/integrator=rk4", 400, "declared 4"},
                          Case{"in-house", 400, "the integrator chooses its own steps, held to order 4"},
                          Case{"ode", 1e4, "declared 1"}}) {
    const results::Verdict verdict =
        conformance::verdict(scenario, row.engine, scenario.duration / row.steps);
    EXPECT_EQ(results::name(verdict.status), "pass")
        << row.engine << ": " << verdict.measured << " of " << verdict.allowed << "; " << verdict.detail;
    EXPECT_NE(verdict.detail.find(row.detail), std::string::npos) << row.engine << ": " << verdict.detail;
  }
}

// A claim that knows high orders alone says nothing good of an integrator of low order.
TEST(TheoryClaim, NoConstantForOrderFails) {
  const auto scenario = spring("{ order = true, constants = { 4 = 1.0 }, reason = \"truncation: theory\" }");
  const results::Verdict verdict =
      conformance::verdict(scenario, "in-house/integrator=velocity-verlet", scenario.duration / 1e3);
  EXPECT_EQ(results::name(verdict.status), "fail");
  EXPECT_NE(verdict.detail.find("no constant for order 2 or less"), std::string::npos) << verdict.detail;
}

}  // namespace
}  // namespace cylon::conformance
