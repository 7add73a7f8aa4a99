// The observed order of every fixed-step integrator of the engine, in double, on smooth reference scenes of
// every kind: springs, drag, drive, two bodies, free and pivoted tops.  The steps are chosen by rule, the
// same for all.  (tests/engine/long has the integrators alone, over more decades.)
#include "engine/integrators/integrator.h"
#include "tests/conformance/accuracy/runner.h"
#include "tests/engine/order_fit.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace cylon::accuracy {
namespace {

// How far the fit may be from the order.  Measured: at most 0.085, rk8 on spring_orbit; 0.04 of order 4, 0.02
// of the others.
constexpr double reach = 0.1;

constexpr const char* scenes[] = {"damped_spring_under", "driven_spring",       "spring_orbit",
                                  "two_body_spring",     "free_asymmetric_top", "heavy_top_nutating",
                                  "kovalevskaya"};

// Over the first quarter of the samples, where the motion hardly amplifies errors; an eighth of them where
// low orders need many steps.
TruthScene beginning(const std::string& file, int order) {
  TruthScene truth = truth_scenes(file).at(0);
  truth.samples.resize(truth.samples.size() / (order < 4 ? 8 : 4) + 1);
  return truth;
}

// The root of the mean square, over the samples and all that is known of all bodies, SI units mixed; of the
// truth's own where it is more than 1.  A mean rather than the largest: it is smooth in the step, and
// rounding at one sample counts for little.
double mean_error(core::Simulator& simulator, const TruthScene& truth, core::Setup setup, const Grid& grid,
                  int n) {
  setup.dt = grid.spacing / n;
  simulator.load(truth.scene, setup);
  core::State state;
  double sum = 0, size = 0;
  long done = 0;
  for (const Sample& sample : grid.samples) {
    const long steps = std::lround(sample.time / grid.spacing) * n;
    for (; done < steps; ++done) simulator.step();
    simulator.read(state);
    for (const Expected& e : sample.bodies) {
      const core::BodyState& s = state[static_cast<std::size_t>(e.body)];
      const auto add = [&](double error, double length) { sum += error * error, size += length * length; };
      if (e.position) add((s.position - *e.position).norm(), e.position->norm());
      if (e.velocity) add((s.velocity - *e.velocity).norm(), e.velocity->norm());
      if (e.orientation) add(angle_between(s.orientation, *e.orientation), 1);
      if (e.angular_velocity)
        add((s.angular_velocity - *e.angular_velocity).norm(), e.angular_velocity->norm());
    }
  }
  return std::sqrt(sum / std::max(size, 1.0));
}

// From one step per sample downward.
Convergence converge(core::Simulator& simulator, const TruthScene& truth, const core::Setup& setup,
                     int order) {
  const Grid grid = grids(truth.samples).at(0);
  const int last = order == 1 ? 1 << 13 : order == 2 ? 1 << 11 : 1 << 10;
  const double least = std::numeric_limits<double>::epsilon() * std::max(10.0, truth.conditioning);
  return cylon::converge(fine_ladder(order < 3 ? last / 256 : 1, last), grid.spacing, least,
                         [&](int n) { return mean_error(simulator, truth, setup, grid, n); });
}

class Order : public testing::TestWithParam<const char*> {};

// Where an integrator cannot show its order: what it moves exactly, and what it moves to rounding by steps
// that are long against the motion.  Any other integrator that does not show it fails.
const std::map<std::string, std::vector<std::string>> blind = {{"kovalevskaya", {"rk8", "rkn6"}}};

TEST_P(Order, OfEveryFixedStepIntegratorIsTheDeclaredOne) {
  const auto simulator = core::make_simulator();
  int seen = 0;
  for (const core::Integrator& integrator : simulator->engine().integrators) {
    if (integrator.adaptive) continue;
    const TruthScene truth = beginning(GetParam(), integrator.order);
    core::Setup setup;
    setup.integrator = integrator.name;
    setup.dt = grids(truth.samples).at(0).spacing;
    SCOPED_TRACE(integrator.name);
    if (const auto reason = simulator->unsupported(truth.scene, setup)) {
      fmt::print("{:22} {:20} {}\n", GetParam(), integrator.name, *reason);
      continue;
    }
    const int order = simulator->load(truth.scene, setup).order;  // as declared for this scene
    const Convergence c = converge(*simulator, truth, setup, integrator.order);
    ++seen;
    if (c.exact) {
      fmt::print("{:22} {:20} exact\n", GetParam(), integrator.name);
      continue;
    }
    const auto excused = blind.find(GetParam());
    const bool none = excused != blind.end() && std::ranges::count(excused->second, integrator.name) > 0;
    EXPECT_EQ(!c.tells(), none) << c.step.size() << " steps between rounding, " << c.floor
                                << ", and what is not small against the motion";
    if (!c.tells()) {
      fmt::print("{:22} {:20} no room in double\n", GetParam(), integrator.name);
      continue;
    }
    const bool reversible = engine::find_integrator(integrator.name)->reversible;
    const double fit = fitted_order(c.step, c.error, reversible);
    fmt::print("{:22} {:20} order {:6.3f} of {}  errors {:.1e} to {:.1e}  floor {:.1e}\n", GetParam(),
               integrator.name, fit, order, c.error.front(), c.error.back(), c.floor);
    EXPECT_NEAR(fit, order, reach);
  }
  EXPECT_GT(seen, 0);
}

// An integrator may refuse a scene, with a reason, but must show its order on most of them.
TEST(OrderTest, EveryIntegratorIsSeenOnFourScenes) {
  const auto simulator = core::make_simulator();
  for (const core::Integrator& integrator : simulator->engine().integrators) {
    if (integrator.adaptive) continue;
    int seen = 0;
    for (const char* file : scenes) {
      core::Setup setup;
      setup.integrator = integrator.name;
      setup.dt = 0.01;
      seen += !simulator->unsupported(beginning(file, integrator.order).scene, setup);
    }
    EXPECT_GE(seen, 4) << integrator.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Order, testing::ValuesIn(scenes),
                         [](const auto& parameter) { return std::string(parameter.param); });

}  // namespace
}  // namespace cylon::accuracy
