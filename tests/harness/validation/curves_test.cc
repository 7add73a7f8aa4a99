// Curves of measured motions: turns of a chain are counted, as an arm that went around once more is no right prediction.
#include "harness/validation/curves.h"

#include "harness/validation/drawing.h"
#include "reference/measured/coordinates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cylon::validation {
namespace {

using measured::Experiment;

// Two arms, the first to the world.
Experiment arms() {
  Experiment e;
  e.coordinates = measured::Coordinates::chain;
  e.bodies = {0, 1};
  e.rate = 50, e.model.step = 0.02, e.angle_noise = 0.01;
  core::Scene& scene = e.model.scene;
  for (int i = 0; i < 2; ++i) {
    core::Body& arm = scene.bodies.emplace_back();
    arm.initial.position = {0.1, -0.2 - 0.4 * i, 0};
    core::Joint& hinge = scene.joints.emplace_back();
    hinge.type = core::JointType::hinge, hinge.axis = core::Vector3::UnitZ();
    hinge.body = i, hinge.to = i - 1, hinge.point = {0, -0.4 * i, 0};
  }
  e.start = Eigen::Vector4d(0.03, 0.02, 0.1, 0.2).asDiagonal();
  return e;
}

constexpr double first = 9, second = -7.5;  // [rad/s]

// Both arms turn evenly.
core::State at(const Experiment& e, double t) {
  return measured::chain_state(e.model.scene, e.bodies, Eigen::Vector2d(2.9 + first * t, -2.7 + second * t),
                               Eigen::Vector2d(first, second));
}

// An engine that turns the arms on from where they start; `more` adds to their rates.
study::Runner turning(const Experiment& e, double more = 0) {
  return [e, more](const core::Scene& started, double dt, std::int64_t steps, std::int64_t every) {
    core::State start;
    for (const core::Body& body : started.bodies) start.push_back(body.initial);
    const Eigen::VectorXd angles = measured::chain_angles(e.model.scene, e.bodies, start),
                          rates = measured::chain_rates(e.model.scene, e.bodies, start).array() + more;
    core::Recording r;
    r.dt = dt;
    for (std::int64_t i = 0; i <= steps; i += every) {
      r.steps.push_back(i);
      r.states.push_back(measured::chain_state(e.model.scene, e.bodies,
                                               angles + static_cast<double>(i) * dt * rates, rates));
    }
    return r;
  };
}

std::vector<core::State> motion(const Experiment& e) {
  std::vector<core::State> states;
  for (int i = 0; i < 60; ++i) states.push_back(at(e, i / e.rate));
  return states;
}

TEST(Curves, CountTurnsOfAChain) {
  const Experiment e = arms();
  const Eigen::MatrixXd c = curves(e, motion(e), at(e, 0));
  for (Eigen::Index i = 0; i < c.rows(); ++i) {
    const double t = static_cast<double>(i) / e.rate;
    EXPECT_NEAR(c(i, 0), 2.9 + first * t, 1e-9);
    EXPECT_NEAR(c(i, 1), -2.7 + second * t, 1e-9);
  }
}

// A start that erred across pi begins beside the measured one, not a turn away from it.
TEST(Curves, BeginBesideAnotherState) {
  const Experiment e = arms();
  const core::State across = measured::moved(e, at(e, 0), Eigen::Vector4d(0.5, -0.6, 0, 0));
  const Eigen::MatrixXd c = curves(e, {across}, at(e, 0));
  EXPECT_NEAR(c(0, 0), 3.4, 1e-9);
  EXPECT_NEAR(c(0, 1), -3.3, 1e-9);
}

TEST(Curves, AreDrawnWithTheirBandAndTheMeasuredBodies) {
  Experiment e = arms();
  e.runs = {{"a", motion(e)}};
  const Drawing d = drawing(e, 0, turning(e, 0.3), {.members = 39});
  ASSERT_EQ(d.failure, "");
  EXPECT_NEAR(d.predicted(59, 0) - d.measured(59, 0), 0.3 * 59 / e.rate, 1e-9);
  EXPECT_TRUE((d.band.low.array() <= d.predicted.array()).all());
  EXPECT_TRUE((d.predicted.array() <= d.band.high.array()).all());
  EXPECT_GT((d.band.high - d.band.low).row(59).minCoeff(), (d.band.high - d.band.low).row(0).maxCoeff());
  EXPECT_LT((d.seen[59][1].position - at(e, 59 / e.rate)[1].position).norm(), 1e-9);
  EXPECT_GT((d.poses[59][1].position - d.seen[59][1].position).norm(), 0.01);
  EXPECT_TRUE(d.turn.empty());
}

}  // namespace
}  // namespace cylon::validation
