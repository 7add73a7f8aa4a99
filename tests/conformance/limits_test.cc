// Limits measured on real engines against theory, and against their known internal limits.
#include "tests/conformance/fixture.h"

#include "harness/study/limits.h"
#include "harness/study/limits_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

namespace cylon::conformance {
namespace {

const study::Family& family(const std::string& name) {
  for (const study::Family& row : study::families())
    if (row.name == name) return row;
  throw std::invalid_argument(name);
}

study::Limit measured(const study::Family& row, const std::string& id,
                      const std::optional<double>& theory = {}) {
  return study::limit_of(row, study::worker_runner(engine(id), {}), theory);
}

struct Row {
  const char *family, *engine, *name, *integrator;
};

// Wherever theory has a number; 1 %: find_limit gives half of it.
TEST(Limits, WithinOnePercentOfTheory) {
  const Row table[] = {
      {"spring", "in-house/integrator=lie-trotter", "in-house", "lie-trotter"},
      {"spring", "in-house/integrator=velocity-verlet", "in-house", "velocity-verlet"},
      {"spring", "in-house/integrator=stormer-verlet", "in-house", "stormer-verlet"},
      {"spring", "in-house/integrator=rk4", "in-house", "rk4"},
      {"spring", "in-house/integrator=yoshida4", "in-house", "yoshida4"},
      {"spring", "in-house/integrator=yoshida6", "in-house", "yoshida6"},
      {"spring", "in-house/integrator=bm4", "in-house", "bm4"},
      {"spring", "in-house/integrator=rkn4", "in-house", "rkn4"},
      {"spring", "bullet", "bullet", "semi-implicit-euler"},
      {"spring", "bullet-float", "bullet", "semi-implicit-euler"},
      {"spring", "bullet-multibody", "bullet", "semi-implicit-euler"},
      {"spring", "ode", "ode", "semi-implicit-euler"},
      {"stiffness", "in-house/integrator=lie-trotter", "in-house", "lie-trotter"},
      {"stiffness", "in-house/integrator=rk4", "in-house", "rk4"},
      {"stiffness", "bullet", "bullet", "semi-implicit-euler"},
      {"stiffness", "ode", "ode", "semi-implicit-euler"},
      {"damping", "in-house/integrator=explicit-euler", "in-house", "explicit-euler"},
      {"damping", "in-house/integrator=rk4", "in-house", "rk4"},
      {"damping", "bullet", "bullet", "semi-implicit-euler"},
      {"damping", "ode", "ode", "semi-implicit-euler"},
      {"turn", "bullet", "bullet", "semi-implicit-euler"},
      {"spring-run", "in-house/integrator=velocity-verlet", "in-house", "velocity-verlet"},
      {"spring-run", "in-house/integrator=explicit-euler", "in-house", "explicit-euler"},
      {"spring-run", "bullet", "bullet", "semi-implicit-euler"},
  };
  for (const Row& row : table) {
    SCOPED_TRACE(std::string(row.family) + " on " + row.engine);
    const study::Family& f = family(row.family);
    const auto theory = f.theory(row.name, row.integrator);
    ASSERT_TRUE(theory && *theory > 0 && std::isfinite(*theory));
    const study::Limit limit = measured(f, row.engine, theory);
    EXPECT_EQ(limit.kind, study::Limit::Kind::found);
    EXPECT_NEAR(limit.value(f.range), *theory, 0.01 * *theory) << limit.what;
  }
}

TEST(Limits, ExplicitEulerNeverHoldsAndDefaultNeverFails) {
  const study::Family& spring = family("spring");
  EXPECT_EQ(*spring.theory("in-house", "explicit-euler"), 0);
  EXPECT_EQ(measured(spring, "in-house/integrator=explicit-euler").kind, study::Limit::Kind::nowhere);
  EXPECT_EQ(measured(spring, "in-house").kind, study::Limit::Kind::none);
  EXPECT_EQ(measured(family("turn"), "in-house").kind, study::Limit::Kind::none);
}

constexpr struct {
  const char* engine;
  double epsilon;
} precisions[] = {{"in-house", 2.220446049250313e-16}, {"in-house-float", 1.1920928955078125e-7}};

// The places of both ends of the spring are known to half a unit u in x and in z, so its length of 1.5 m to
// sqrt 2 u (engine/resolution.h), and u is epsilon x or up to half of that: a hundredth of the orbit is lost
// where the bound says so.
TEST(Limits, TheOrbitIsLostWhereTheStoredPlacesSay) {
  study::Family origin = family("origin");
  for (const auto& row : precisions) {
    const double expected = 0.01 * 1.5 / (std::sqrt(2) * row.epsilon);
    origin.range = {.low = expected / 20, .high = expected * 4, .per_decade = 1, .closeness = 1.1};
    const study::Limit limit = measured(origin, row.engine);
    ASSERT_EQ(limit.kind, study::Limit::Kind::found) << row.engine;
    EXPECT_GT(limit.value(origin.range), expected / 2);
    EXPECT_LT(limit.value(origin.range), expected * 2.2);
  }
}

// A ball of half a metre that falls on a floor at height x.
study::Probed fall_at(const study::Runner& run, double x) {
  core::Scene scene;
  core::Body ball;
  ball.name = "ball", ball.shape = core::Sphere{0.5}, ball.collide = true;
  ball.inertia = core::Matrix3::Identity() * 0.1;
  ball.initial.position = {0, x + 2, 0};
  scene.bodies = {ball};
  scene.planes = {{"floor", core::Vector3::UnitY(), x}};
  scene.materials = {{{"*", "*"}, 0.5, 0}};
  scene.forces = {core::UniformGravity{}};
  run(scene, 0.01, 4, 1);
  return {};
}

// Where an engine refuses beyond a value that holds, that value is its limit: where the distance to the floor
// is known to u, which is a tenth of the ball's half-width.
TEST(Limits, UnsupportedValueIsALimit) {
  study::Family floor = family("origin");
  floor.probe = fall_at;
  for (const auto& row : precisions) {
    const double expected = 0.05 / row.epsilon;  // u is epsilon x or up to half of that
    floor.range = {.low = expected / 20, .high = expected * 20, .per_decade = 1, .closeness = 1.1};
    const study::Limit limit = measured(floor, row.engine);
    ASSERT_EQ(limit.kind, study::Limit::Kind::found) << row.engine;
    EXPECT_GT(limit.value(floor.range), expected / 1.1);
    EXPECT_LT(limit.value(floor.range), expected * 2.2);
    EXPECT_EQ(limit.what.find("unsupported: 'ball' is "), 0u) << limit.what;
    EXPECT_NE(limit.what.find("more than a tenth of its half-width"), std::string::npos) << limit.what;
  }
}

// The bracket holds on one side and breaks on the other, asked again.
TEST(Limits, TheLargestStepOfAScenarioIsBracketed) {
  const scenario::Scenario scenario = shipped("projectile");
  const study::StepSearch search = study::step_search(scenario);
  const study::Limit limit = study::find_limit(search.range, [&](double n) {
    return study::step_probe(scenario, engine("bullet"), {}, search.unit * static_cast<std::int64_t>(n));
  });
  ASSERT_EQ(limit.kind, study::Limit::Kind::found);
  const auto holds = [&](double n) {
    return study::step_probe(scenario, engine("bullet"), {}, search.unit * static_cast<std::int64_t>(n))
        .holds;
  };
  EXPECT_TRUE(holds(limit.holds));
  EXPECT_FALSE(holds(limit.breaks));
}

}  // namespace
}  // namespace cylon::conformance
