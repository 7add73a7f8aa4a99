// The observed order of every fixed-step scheme of the engine on smooth reference scenes of every kind:
// springs, drag, drive, two bodies, free and pivoted tops.  The steps are chosen by rule, the same for all.
#include "tests/accuracy/runner.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

namespace cylon::accuracy {
namespace {

constexpr double reach = 0.1;    // how far the slope may be from the order
constexpr int most = 1 << 15;    // steps between samples
constexpr int points = 4;        // that the slope is fitted to
constexpr double coarse = 1e-2;  // an error above this, relative, is not small against the motion

constexpr const char* scenes[] = {"damped_spring_under", "driven_spring",       "spring_orbit",
                                  "two_body_spring",     "free_asymmetric_top", "heavy_top_nutating",
                                  "kovalevskaya"};

// The first eighth of the samples: errors of the way there are hardly amplified yet.
TruthScene beginning(const std::string& file) {
  TruthScene truth = truth_scenes(file).at(0);
  truth.samples.resize(truth.samples.size() / 8 + 1);
  return truth;
}

// 1, 2, 3, 4, 6, 8, 12, …
int next(int n) { return n < 2 ? n + 1 : (n & (n - 1)) == 0 ? n / 2 * 3 : n / 3 * 4; }

struct Convergence {
  std::vector<double> step, error;  // above the floor and below `coarse`
  double floor = 0;
  bool exact = false;  // at the floor with the largest step already

  // Least squares through the smallest steps.
  double slope() const {
    const std::size_t n = std::min<std::size_t>(points, step.size()), first = step.size() - n;
    double x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = first; i < step.size(); ++i) {
      const double a = std::log(step[i]), b = std::log(error[i]);
      x += a, y += b, xx += a * a, xy += a * b;
    }
    const auto count = static_cast<double>(n);
    return (count * xy - x * y) / (count * xx - x * x);
  }
};

// From one step per sample downward, until rounding shows: a thousand eps, amplified by the motion (ten times
// at least, as some files do not say).
Convergence converge(core::Simulator& simulator, const TruthScene& truth, core::Setup setup) {
  Convergence result;
  result.floor = 1e3 * std::numeric_limits<double>::epsilon() * std::max(10.0, truth.conditioning);
  const Grid grid = grids(truth.samples).at(0);
  for (int n = 1; n <= most; n = next(n)) {
    Deviations found;
    run(simulator, truth.scene, setup, grid, n, found);
    const double error = found.worst();
    if (error <= result.floor) {
      result.exact = n == 1;
      break;
    }
    if (!(error < coarse)) continue;  // NaN as well
    result.step.push_back(grid.spacing / n);
    result.error.push_back(error);
  }
  return result;
}

class Order : public testing::TestWithParam<const char*> {};

TEST_P(Order, OfEveryFixedStepSchemeIsTheDeclaredOne) {
  const auto simulator = core::make_simulator();
  const TruthScene truth = beginning(GetParam());
  int seen = 0;
  for (const core::Scheme& scheme : simulator->engine().schemes) {
    if (scheme.adaptive) continue;
    core::Setup setup;
    setup.integrator = scheme.name;
    setup.dt = grids(truth.samples).at(0).spacing;
    SCOPED_TRACE(scheme.name);
    if (const auto reason = simulator->unsupported(truth.scene, setup)) {
      fmt::print("{:22} {:20} {}\n", GetParam(), scheme.name, *reason);
      continue;
    }
    const Convergence c = converge(*simulator, truth, setup);
    ++seen;
    if (c.exact) {
      fmt::print("{:22} {:20} exact: below {:.1e} at the largest step\n", GetParam(), scheme.name, c.floor);
      continue;
    }
    ASSERT_GE(c.step.size(), 3u) << "too few steps between " << coarse << " and the floor " << c.floor;
    fmt::print("{:22} {:20} order {:5.2f} of {}  at dt {:.1e} error {:.1e}  floor {:.1e}\n", GetParam(),
               scheme.name, c.slope(), scheme.order, c.step.back(), c.error.back(), c.floor);
    EXPECT_NEAR(c.slope(), scheme.order, reach);
  }
  EXPECT_GT(seen, 0);
}

// A scheme may refuse a scene, with a reason, but must show its order on most of them.
TEST(OrderTest, EverySchemeIsSeenOnFourScenes) {
  const auto simulator = core::make_simulator();
  for (const core::Scheme& scheme : simulator->engine().schemes) {
    if (scheme.adaptive) continue;
    int seen = 0;
    for (const char* file : scenes) {
      core::Setup setup;
      setup.integrator = scheme.name;
      setup.dt = 0.01;
      seen += !simulator->unsupported(beginning(file).scene, setup);
    }
    EXPECT_GE(seen, 4) << scheme.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Order, testing::ValuesIn(scenes),
                         [](const auto& parameter) { return std::string(parameter.param); });

}  // namespace
}  // namespace cylon::accuracy
