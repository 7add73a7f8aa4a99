// IFToMM's spatial slider-crank, against the solution of its one freedom and against what two teams published of theirs.
#include "harness/core/observable.h"
#include "harness/scenario/scenario.h"
#include "tests/conformance/accuracy/runner.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace cylon::accuracy {
namespace {

struct Published {
  double time;                // [s]
  double gonzalez, masarati;  // the slider's place [m]
  double crank;               // Masarati's [rad]
};
constexpr Published published[] = {{0.1, 0.226785384, 0.2267867, 0.5600213536},
                                   {0.5, 0.184952803, 0.1849586, 5.574337285},
                                   {1, 0.211754668, 0.2124956, 10.89762117}};
// How far the digits of the teams are from the motion at these times, at most.
constexpr double gonzalez_errs = 3.4e-5, masarati_errs = 7.8e-4, crank_errs = 0.016;

class SliderCrank : public testing::Test {
 protected:
  scenario::Scenario scenario_ =
      scenario::load(std::filesystem::path(source_dir) / "scenarios/slider_crank_spatial.toml");
};

// The truth by other code than made it: of one freedom, what keeps its joints closed and its energy is the motion up to its time.
TEST_F(SliderCrank, IsTrueToItsJointsAndItsEnergy) {
  const auto follows =
      std::ranges::find_if(scenario_.claims, [](const core::Claim& c) { return c.truth.has_value(); });
  ASSERT_NE(follows, scenario_.claims.end());
  const core::State start = core::initial_state(scenario_.scene);
  for (const core::Quantity quantity :
       {core::Quantity::energy, core::Quantity::joint_gap, core::Quantity::angular_joint_gap}) {
    const core::Observable observable{.quantity = quantity};
    core::Values before, now;
    core::evaluate(observable, scenario_.scene, start, before);
    for (const double time : follows->truth->times) {
      now.clear();
      core::evaluate(observable, scenario_.scene, follows->truth->state(time), now);
      EXPECT_LE(core::distance(observable, before, now), 1e-10) << core::name(quantity) << " at " << time;
    }
  }
}

TEST_F(SliderCrank, HasTheMotionOfItsOneFreedom) {
  const auto simulator = core::make_simulator();
  core::Setup setup;
  setup.integrator = "auto", setup.dt = 1. / 1000;
  simulator->load(scenario_.scene, setup);
  const auto follows =
      std::ranges::find_if(scenario_.claims, [](const core::Claim& c) { return c.truth.has_value(); });
  ASSERT_NE(follows, scenario_.claims.end());
  core::State state;
  int step = 0;
  for (const double time : follows->truth->times) {
    for (; step < std::lround(time * 1000); ++step) simulator->step();
    simulator->read(state);
    const core::State truth = follows->truth->state(time);
    for (std::size_t i = 0; i < state.size(); ++i) {
      EXPECT_LE((state[i].position - truth[i].position).norm(), 1e-9) << i << " at " << time;
      EXPECT_LE((state[i].velocity - truth[i].velocity).norm(), 1e-8) << i << " at " << time;
    }
    for (const Published& one : published) {
      if (std::abs(one.time - time) > 1e-9) continue;
      EXPECT_NEAR(state[2].position.x(), one.gonzalez, gonzalez_errs) << time;
      EXPECT_NEAR(state[2].position.x(), one.masarati, masarati_errs) << time;
      const core::Quaternion& q = state[0].orientation;
      EXPECT_NEAR(std::remainder(2 * std::atan2(q.x(), q.w()) - one.crank, 2 * std::numbers::pi), 0,
                  crank_errs)
          << time;
    }
  }
}

}  // namespace
}  // namespace cylon::accuracy
