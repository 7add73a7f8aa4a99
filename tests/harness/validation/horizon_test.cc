// The prediction horizon of a chain: a pendulum of small swings, of which the error can be written down.
#include "harness/validation/horizon.h"

#include "harness/validation/normal.h"
#include "reference/measured/coordinates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cylon::validation {
namespace {

using measured::Experiment;

constexpr double rate = 3;  // of growth [1/s]

// An inverted pendulum near its top, a'' = rate^2 a: a = a0 cosh(rate t) + (a0'/rate) sinh(rate t).  `pull` adds rate^2 pull.
study::Runner inverted(const Experiment& e, double pull = 0) {
  return [scene = e.model.scene, bodies = e.bodies, pull](const core::Scene& started, double dt,
                                                          std::int64_t steps, std::int64_t every) {
    const core::State start = {started.bodies[0].initial};
    const double a = measured::chain_angles(scene, bodies, start)[0] + pull,
                 b = measured::chain_rates(scene, bodies, start)[0] / rate;
    core::Recording r;
    r.dt = dt;
    for (std::int64_t i = 0; i <= steps; i += every) {
      const double t = rate * dt * static_cast<double>(i);
      const Eigen::VectorXd angle = Eigen::VectorXd::Constant(1, a * std::cosh(t) + b * std::sinh(t) - pull),
                            speed =
                                Eigen::VectorXd::Constant(1, rate * (a * std::sinh(t) + b * std::cosh(t)));
      r.steps.push_back(i), r.states.push_back(measured::chain_state(scene, bodies, angle, speed));
    }
    return r;
  };
}

Experiment upright() {
  Experiment e;
  e.coordinates = measured::Coordinates::chain;
  e.bodies = {0};
  e.rate = 100, e.model.step = 0.01, e.angle_noise = 1e-4;
  core::Body arm;
  arm.initial.position = {0, 1, 0};
  e.model.scene.bodies = {arm};
  core::Joint joint;
  joint.type = core::JointType::hinge, joint.axis = core::Vector3::UnitZ();
  e.model.scene.joints = {joint};
  e.start = Eigen::Vector2d(1e-3, 2e-3).asDiagonal();
  const core::State start = measured::chain_state(e.model.scene, e.bodies, Eigen::VectorXd::Constant(1, 1e-3),
                                                  Eigen::VectorXd::Constant(1, -2e-3));
  core::Scene scene = measured::started(e, start);
  e.runs = {{"1", inverted(e)(scene, 0.01, 250, 1).states}};
  return e;
}

TEST(Horizons, AreWhatTheLawOfErrorsSays) {
  const Experiment e = upright();
  // The prediction of a law that is off by `pull` errs by pull (cosh(rate t) - 1).
  constexpr double pull = 2e-3;
  const Horizon h = horizon(e, 0, inverted(e, pull));
  const double frame = 1 / e.rate;
  EXPECT_NEAR(h.held, std::acosh(1 + 0.1 / pull) / rate, frame);
  const auto deviation = [&](double t) {
    return std::hypot(1e-3 * std::cosh(rate * t), 2e-3 / rate * std::sinh(rate * t));
  };
  EXPECT_GE(0.6745 * deviation(h.expected), 0.1);
  EXPECT_LT(0.6745 * deviation(h.expected - frame), 0.1);
  EXPECT_NEAR(h.exponent, std::log(std::cosh(rate * h.expected)) / h.expected, 1e-6);
  EXPECT_EQ(horizon(e, 0, inverted(e)).held, std::numeric_limits<double>::infinity());
}

// Of a right model nothing but the start is wrong, and the time that runs hold is the one that their starts' covariance says.
TEST(Horizons, OfARightModelAreWhatTheStartsErrorsSay) {
  Experiment e = upright();
  const measured::Run clean = e.runs[0];
  e.runs.clear();
  for (std::uint64_t k = 0; k < 200; ++k) {
    Normal normal(3, k, 0);
    measured::Run seen = clean;
    const double angle = normal(1e-3), speed = normal(2e-3);
    seen.states[0] = measured::moved(e, clean.states[0], Eigen::Vector2d(angle, speed));
    e.runs.push_back(seen);
  }
  std::vector<Horizon> all;
  for (std::size_t i = 0; i < e.runs.size(); ++i) all.push_back(horizon(e, i, inverted(e)));
  const HorizonSummary s = summary(all);
  EXPECT_LE(s.held.interval.low, s.expected.value);
  EXPECT_GE(s.held.interval.high, s.expected.value);
  EXPECT_LT(s.held.interval.high - s.held.interval.low, 0.15);
  // A model that is off by more than its starts are does not hold as long as they let expect.
  all.clear();
  for (std::size_t i = 0; i < e.runs.size(); ++i) all.push_back(horizon(e, i, inverted(e, 0.01)));
  EXPECT_LT(summary(all).held.interval.high, s.expected.value);
}

// The band of a chain holds as many angles as it says of a right model, and too few of a wrong one.
TEST(Horizons, HaveABandOfAngles) {
  Experiment e = upright();
  const measured::Run clean = e.runs[0];
  e.runs.clear();
  for (std::uint64_t k = 0; k < 200; ++k) {
    Normal normal(5, k, 0);
    measured::Run seen = clean;
    for (core::State& state : seen.states)
      state = measured::moved(e, state, Eigen::Vector2d(normal(e.angle_noise), 0));
    const double angle = normal(1e-3), speed = normal(2e-3);
    seen.states[0] = measured::moved(e, clean.states[0], Eigen::Vector2d(angle, speed));
    e.runs.push_back(seen);
  }
  const auto band = [&](double pull) {
    std::vector<Horizon> all;
    for (std::size_t i = 0; i < e.runs.size(); ++i)
      all.push_back(horizon(e, i, inverted(e, pull), {.members = 39}, {}));
    return summary(all);
  };
  const HorizonSummary right = band(0);
  EXPECT_LE(right.covered.interval.low, 0.95);
  EXPECT_GE(right.covered.interval.high, 0.95);
  EXPECT_NE(right.band, Answer::outside);
  EXPECT_EQ(band(0.01).band, Answer::outside);
}

TEST(Horizons, CountRunsThatHoldToTheEndAsLongest) {
  std::vector<Horizon> runs;
  for (int i = 0; i < 7; ++i) runs.push_back({.run = "", .failure = {}, .held = i < 5 ? 1.0 + i : HUGE_VAL});
  runs.push_back({.run = "", .failure = "crash"});
  const HorizonSummary s = summary(runs);
  EXPECT_EQ(s.held.value, 4);
  EXPECT_EQ(s.to_the_end, 2u);
  EXPECT_EQ(s.failed, 1u);
  EXPECT_EQ(s.first_failure, "crash");
  EXPECT_EQ(s.held.interval.high, HUGE_VAL);
}

// One of two runs holds to the end, and the other one 6 s: "the end" was said to be their median.
TEST(Horizons, OfHalfTheRunsToTheEndAreThoseOfTheOthers) {
  std::vector<Horizon> runs(8);
  for (std::size_t i = 0; i < runs.size(); ++i)
    runs[i].held = i < 4 ? 3.0 + static_cast<double>(i) : HUGE_VAL, runs[i].expected = runs[i].exponent = 1;
  EXPECT_EQ(summary(runs).held.value, 6);
  EXPECT_EQ(summary(runs).held.interval.high, HUGE_VAL);
  runs.erase(runs.begin());
  EXPECT_EQ(summary(runs).held.value, HUGE_VAL);
}

TEST(Horizons, SayWhyThereIsNone) {
  const Experiment e = upright();
  const study::Runner breaks = [](const auto&...) -> core::Recording {
    process::RunOutcome outcome;
    outcome.reason = "it fell asleep";
    throw study::RunFailed{outcome};
  };
  EXPECT_EQ(horizon(e, 0, breaks).failure, "it fell asleep");
}

}  // namespace
}  // namespace cylon::validation
