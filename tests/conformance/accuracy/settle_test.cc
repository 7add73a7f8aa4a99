// How box_drop_edge ends: no formula for the way, but the energy never grows and the box rests on a face.
#include "harness/core/observable.h"
#include "tests/conformance/accuracy/runner.h"
#include "tests/conformance/accuracy/truth/truth_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cylon::accuracy {
namespace {

constexpr double bound = 1e-9;  // as in truths_test.cc: ten times the tolerance asked for

double energy(const core::Scene& scene, const core::State& state) {
  core::Observable observable;
  observable.quantity = core::Quantity::energy;
  core::Values values;
  core::evaluate(observable, scene, state, values);
  return values.at(0).x();
}

TEST(BoxDropEdge, EnergyNeverGrowsAndTheBoxRestsOnAFace) {
  const json file = read_truth("box_drop_edge");
  const core::Scene scene = truth_scenes("box_drop_edge").at(0).scene;
  const auto simulator = core::make_simulator();
  core::Setup setup;
  setup.integrator = "auto";
  setup.tolerance = bound / 10;
  setup.dt = 0.01;
  ASSERT_EQ(simulator->unsupported(scene, setup), std::nullopt);
  simulator->load(scene, setup);
  core::State state = core::initial_state(scene);
  const double start = energy(scene, state);
  double last = start, growth = 0;
  for (int step = 0; step < 600; ++step) {  // 6 s: it falls for 0.56 s, and loses three quarters at each blow
    simulator->step();
    simulator->read(state);
    const double now = energy(scene, state);
    growth = std::isnan(now) || now - last > growth ? now - last : growth;
    last = now;
  }
  EXPECT_LE(growth, bound * start);
  double nearest = 1;
  for (const json& height : file["rest_heights"])
    nearest = std::min(nearest, std::abs(state[0].position.y() - number(height)));
  EXPECT_LE(nearest, bound) << "rests at " << state[0].position.y();
  EXPECT_LE(state[0].velocity.norm(), bound);
  EXPECT_LE(state[0].angular_velocity.norm(), bound);
  EXPECT_LT(last, start / 2);
}

}  // namespace
}  // namespace cylon::accuracy
