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

constexpr double reach = 0.1;  // how far the slope may be from the order
// From here on double precision leaves less than two octaves of steps between rounding and the terms of
// higher order, and the error changes sign in them: the slope still tells the even orders apart, and no more.
constexpr int high = 6;
constexpr double high_reach = 1;
constexpr int most = 1 << 15;      // steps between samples
constexpr int points = 4;          // that the slope is fitted to
constexpr double coarse = 1e-2;    // an error above this, relative, is not small against the motion
constexpr double rounding = 1e-7;  // nor is one above this rounding

constexpr const char* scenes[] = {"damped_spring_under", "driven_spring",       "spring_orbit",
                                  "two_body_spring",     "free_asymmetric_top", "heavy_top_nutating",
                                  "kovalevskaya"};

// A scheme of high order reaches rounding before its leading term stands alone: it gets half of the horizon,
// where the error has grown and rounding less; the others an eighth, where the motion hardly amplifies
// errors.
TruthScene beginning(const std::string& file, int order) {
  TruthScene truth = truth_scenes(file).at(0);
  truth.samples.resize(truth.samples.size() / (order < high ? 8 : 2) + 1);
  return truth;
}

// 1, 2, 3, 4, 6, 8, 12, …
int next(int n) { return n < 2 ? n + 1 : (n & (n - 1)) == 0 ? n / 2 * 3 : n / 3 * 4; }

struct Convergence {
  std::vector<double> step, error;  // above the floor and below `coarse`
  double floor = 0;                 // what rounding leaves
  bool exact = false;               // at the floor with the largest step already

  // p of  log error = a + p log h,  least squares through the smallest steps.
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

// From one step per sample downward, until rounding shows: the error falls no more.  Steps whose error is
// less than a hundred times what is left then are not used.
Convergence converge(core::Simulator& simulator, const TruthScene& truth, core::Setup setup) {
  Convergence result;
  const double least = std::numeric_limits<double>::epsilon() * std::max(10.0, truth.conditioning);
  const Grid grid = grids(truth.samples).at(0);
  double previous = std::numeric_limits<double>::infinity();
  for (int n = 1; n <= most; n = next(n)) {
    Deviations found;
    run(simulator, truth.scene, setup, grid, n, found);
    const double error = found.worst();
    if (n == 1 && error <= 1e3 * least) {
      result.exact = true;
      return result;
    }
    const bool falls = error < 0.9 * previous;
    previous = error;
    if (!(error < coarse)) continue;  // NaN as well
    if (error < rounding && !falls) {
      result.floor = error;
      break;
    }
    result.step.push_back(grid.spacing / n);
    result.error.push_back(error);
  }
  while (!result.error.empty() && result.error.back() < 100 * result.floor)
    result.step.pop_back(), result.error.pop_back();
  return result;
}

class Order : public testing::TestWithParam<const char*> {};

TEST_P(Order, OfEveryFixedStepSchemeIsTheDeclaredOne) {
  const auto simulator = core::make_simulator();
  int seen = 0;
  for (const core::Scheme& scheme : simulator->engine().schemes) {
    if (scheme.adaptive) continue;
    const TruthScene truth = beginning(GetParam(), scheme.order);
    core::Setup setup;
    setup.integrator = scheme.name;
    setup.dt = grids(truth.samples).at(0).spacing;
    SCOPED_TRACE(scheme.name);
    if (const auto reason = simulator->unsupported(truth.scene, setup)) {
      fmt::print("{:22} {:20} {}\n", GetParam(), scheme.name, *reason);
      continue;
    }
    const int order = simulator->load(truth.scene, setup).order;  // as declared for this scene
    const Convergence c = converge(*simulator, truth, setup);
    ++seen;
    if (c.exact) {
      fmt::print("{:22} {:20} exact\n", GetParam(), scheme.name);
      continue;
    }
    ASSERT_GE(c.step.size(), 3u) << "too few steps between " << coarse << " and the floor " << c.floor;
    fmt::print("{:22} {:20} order {:5.2f} of {}  at dt {:.1e} error {:.1e}  floor {:.1e}\n", GetParam(),
               scheme.name, c.slope(), order, c.step.back(), c.error.back(), c.floor);
    EXPECT_NEAR(c.slope(), order, order < high ? reach : high_reach);
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
      seen += !simulator->unsupported(beginning(file, scheme.order).scene, setup);
    }
    EXPECT_GE(seen, 4) << scheme.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Order, testing::ValuesIn(scenes),
                         [](const auto& parameter) { return std::string(parameter.param); });

}  // namespace
}  // namespace cylon::accuracy
