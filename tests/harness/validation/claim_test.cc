// Claims against measured motions, on synthetic recordings of which the true deviation is known: a pendulum of small swings and a
// thrown ball, both of which can be written down.
#include "harness/core/uncertain.h"

#include "harness/results/verdict.h"
#include "harness/tracking/statistics/proportion.h"
#include "harness/validation/normal.h"
#include "reference/measured/claim_truth.h"
#include "reference/measured/coordinates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace cylon::validation {
namespace {

using core::Claim, core::Quantity, core::Recording, core::Scene, core::State, core::Vector3;
using measured::Experiment, results::Status;

// The states of a scene's bodies after a time.
using World = std::function<State(const Scene&, double t)>;

Recording ran(const World& world, const Scene& scene, double dt, int steps) {
  Recording r;
  r.dt = dt;
  for (int i = 0; i <= steps; ++i) r.steps.push_back(i), r.states.push_back(world(scene, dt * i));
  return r;
}

double weight(const Scene& scene) {
  return -std::get<core::UniformGravity>(scene.forces[0]).acceleration.y();
}

// a'' = -(g/l) a about the way down.  The scene's own turn against the pendulum that hangs is its angle.
World pendulum(double factor_of_gravity = 1) {
  return [=](const Scene& scene, double t) {
    const core::BodyState& s = scene.bodies[0].initial;
    const Vector3 arm = s.position - scene.joints[0].point;
    const double a = std::atan2(arm.x(), -arm.y()), b = s.angular_velocity.z(),
                 rate = std::sqrt(factor_of_gravity * weight(scene) / arm.norm());
    const std::size_t body[] = {0};
    return core::State(measured::chain_state(
        scene, body, Eigen::VectorXd::Constant(1, a * std::cos(rate * t) + b / rate * std::sin(rate * t) - a),
        Eigen::VectorXd::Constant(1, b * std::cos(rate * t) - a * rate * std::sin(rate * t))));
  };
}

// A ball that flies, and turns at a steady spin.
World flight(double factor_of_gravity = 1) {
  return [=](const Scene& scene, double t) {
    core::BodyState s = scene.bodies[0].initial;
    const Vector3 g(0, -factor_of_gravity * weight(scene), 0);
    s.position += t * s.velocity + t * t / 2 * g;
    s.velocity += t * g;
    s.orientation =
        Eigen::AngleAxisd(s.angular_velocity.norm() * t, s.angular_velocity.normalized()) * s.orientation;
    return State{s};
  };
}

State never_moves(const Scene& scene, double) { return core::initial_state(scene); }

constexpr int frames = 40;  // after the first

Experiment experiment() {
  Experiment e;
  e.file = "synthetic";
  e.rate = 50, e.model.step = 0.02;
  e.bodies = {0};
  core::Body body;
  body.name = "measured";
  body.initial.position = {0, -0.4, 0};
  e.model.scene.bodies = {body};
  e.model.scene.forces = {core::UniformGravity{}};
  return e;
}

Experiment swing() {
  Experiment e = experiment();
  e.coordinates = measured::Coordinates::chain;
  e.angle_noise = 2e-3;
  core::Joint joint;
  joint.type = core::JointType::hinge, joint.axis = Vector3::UnitZ();
  e.model.scene.joints = {joint};
  Eigen::Matrix2d start;  // correlated
  start << 2e-3, 0, 1.5e-2, 2e-2;
  e.start = start;
  return e;
}

Experiment throws() {
  Experiment e = experiment();
  e.noise = 1e-3, e.angle_noise = 5e-3;
  Eigen::VectorXd deviation(12);
  deviation << Vector3::Constant(1e-3), Vector3::Constant(5e-3), Vector3(0.01, 0.02, 0.015),
      Vector3::Constant(0.05);
  e.start = deviation.asDiagonal();
  return e;
}

// What is seen of the world from a true start: every frame errs.
Experiment seen(Experiment e, const World& world, const State& start, std::uint64_t seed) {
  const Scene scene = measured::started(e, start);
  measured::Run run{"7", {}};
  Normal normal(seed, 0, 0);
  for (int k = 0; k <= frames; ++k) {
    Eigen::VectorXd drawn(e.start.cols());
    for (double& one : drawn) one = normal(1);
    run.states.push_back(measured::moved(e, world(scene, k / e.rate), e.start * drawn));
  }
  e.runs = {run};
  return e;
}

struct Case {
  std::string name;
  Experiment like;
  State start;  // the true one
  World right, wrong;
  Claim claim;
};

Claim claim_of(Quantity quantity) {
  Claim claim;
  claim.observable.quantity = quantity;
  claim.follows = "measured";
  return claim;
}

std::vector<Case> cases() {
  const Experiment swinging = swing();
  core::BodyState thrown;
  thrown.position = {0.3, 1.2, -0.7}, thrown.velocity = {1.1, 2.3, -0.4},
  thrown.angular_velocity = {2, -3, 1};
  Claim height = claim_of(Quantity::position);
  height.observable.component = core::Component::y;
  height.reduction = core::Reduction::end;
  const State start =
      measured::chain_state(swinging.model.scene, swinging.bodies, Eigen::VectorXd::Constant(1, 0.5),
                            Eigen::VectorXd::Constant(1, -0.8));
  return {{"angle of a joint", swinging, start, pendulum(), pendulum(1.1), claim_of(Quantity::joint_angle)},
          {"place of an arm", swinging, start, pendulum(), pendulum(1.1), claim_of(Quantity::position)},
          {"place of a ball", throws(), {thrown}, flight(), flight(1.1), claim_of(Quantity::position)},
          {"its height at the end", throws(), {thrown}, flight(), flight(1.1), height},
          {"turn of a ball",
           throws(),
           {thrown},
           flight(),
           [](const Scene& scene, double t) { return flight()(scene, 1.1 * t); },
           claim_of(Quantity::orientation)}};
}

// What an engine's verdict is made of.
core::Measured measured_by(const Case& c, const World& engine, std::uint64_t seed, double tolerance = 0) {
  const Experiment e = seen(c.like, c.right, c.start, seed);
  const Scene scene = measured::started(e, e.runs[0].states.front());
  Claim claim = c.claim;
  const core::MeasuredTruth known = measured::truth(e, e.runs[0], scene);
  claim.truth = known.truth, claim.uncertainty = known.uncertainty;
  claim.tolerance.absolute = tolerance;
  const auto run = [&](const Scene& from) { return ran(engine, from, 1 / e.rate, frames); };
  std::vector<core::Pushed> pushed;
  for (const auto& [up, down] : claim.uncertainty->scenes) pushed.emplace_back(run(up), run(down));
  return core::measure_uncertain(claim, scene, run(scene), pushed);
}

Status verdict(const Case& c, const World& engine, std::uint64_t seed, double tolerance) {
  const auto [low, high] = measured_by(c, engine, seed, tolerance).interval.value();
  return results::judge(results::Bounds{low, high}, tolerance);
}

// How far the engine is from the world, from the true start.
double true_deviation(const Case& c, const World& engine) {
  const Scene scene = measured::started(c.like, c.start);
  double most = 0;
  core::Values a, b;
  for (int k = c.claim.reduction == core::Reduction::end ? frames : 1; k <= frames; ++k) {
    core::evaluate(c.claim.observable, scene, engine(scene, k / c.like.rate), a);
    core::evaluate(c.claim.observable, scene, c.right(scene, k / c.like.rate), b);
    most = std::max(most, core::distance(c.claim.observable, a, b));
  }
  return most;
}

// Of so many with a level of 95 %, fewer hits than this have a probability below 1e-4.
std::size_t least_hits(std::size_t trials) {
  std::size_t hits = trials;
  while (statistics::proportion_interval(hits, trials, 1e-4).high >= 0.95) --hits;
  return hits + 1;
}

constexpr std::size_t experiments = 400;

// The level: of right and of wrong engines.  So a tolerance that is the true deviation itself is decided in one of twenty at most.
TEST(MeasuredClaims, IntervalsHoldTheTrueDeviation) {
  for (const Case& c : cases())
    for (const World& engine : {c.right, c.wrong}) {
      const double truth = true_deviation(c, engine);
      std::size_t held = 0, decided = 0;
      for (std::uint64_t seed = 0; seed < experiments; ++seed) {
        const auto [low, high] = measured_by(c, engine, seed).interval.value();
        held += low <= truth && truth <= high;
        decided += results::judge(results::Bounds{low, high}, truth) != Status::undecided;
      }
      EXPECT_GE(held, least_hits(experiments)) << c.name << ", off by " << truth;
      EXPECT_LE(decided, experiments - least_hits(experiments)) << c.name << ", off by " << truth;
    }
}

// A single number without multiplicity has no room to be cautious: its interval misses in one of twenty, not in fewer.
TEST(MeasuredClaims, IntervalOfOneNumberIsNoWiderThanItMust) {
  const Case height = cases()[3];
  const double truth = true_deviation(height, height.wrong);
  std::size_t held = 0;
  for (std::uint64_t seed = 0; seed < experiments; ++seed) {
    const auto [low, high] = measured_by(height, height.wrong, seed).interval.value();
    held += low <= truth && truth <= high;
  }
  EXPECT_LT(statistics::proportion_interval(held, experiments, 1e-4).low, 0.95) << held;
}

// Tolerances as multiples of how far a wrong engine is off.
TEST(MeasuredClaims, AreDecidedWhereNoiseAllows) {
  for (const Case& c : cases()) {
    const double off = true_deviation(c, c.wrong);
    std::size_t passed = 0, failed = 0, open = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      passed += verdict(c, c.right, seed, off) == Status::pass;
      failed += verdict(c, c.wrong, seed, off / 10) == Status::fail;
      open += verdict(c, c.right, seed, off / 1000) == Status::undecided;
    }
    EXPECT_GE(passed, 95u) << c.name << ": the right engine, a wide tolerance";
    EXPECT_GE(failed, 95u) << c.name << ": 10 % off, and a tenth of what comes of it is allowed";
    EXPECT_GE(open, least_hits(100)) << c.name << ": the right engine, a tolerance within the noise";
  }
}

TEST(MeasuredClaims, EngineThatNeverMovesDoesNotPass) {
  for (const Case& c : cases()) {
    const double far = true_deviation(c, never_moves);
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      EXPECT_NE(verdict(c, never_moves, seed, 0.9 * far), Status::pass) << c.name;
      EXPECT_EQ(verdict(c, never_moves, seed, 0.3 * far), Status::fail) << c.name;
    }
  }
}

// What is not finite proves nothing, in the run and in those from other starts.
TEST(MeasuredClaims, BrokenRunsAreNotFinite) {
  const Case c = cases()[0];
  const auto broken = [&](bool first) {
    return [&, first, n = 0](const Scene& scene, double t) mutable {
      State state = c.right(scene, t);
      if ((n++ <= frames) == first && t > 0.3) state[0].orientation.x() = std::nan("");
      return state;
    };
  };
  for (const bool first : {true, false}) {
    World world = broken(first);
    const auto [low, high] = measured_by(
                                 c, [&](const Scene& s, double t) { return world(s, t); }, 1)
                                 .interval.value();
    EXPECT_EQ(results::judge(results::Bounds{low, high}, 1e3), Status::non_finite) << first;
  }
}

TEST(MeasuredClaims, SayWhatHasNoInterval) {
  Claim claim = claim_of(Quantity::velocity);
  EXPECT_NE(core::no_interval(claim).find("observable: 'velocity' was not measured"), std::string::npos);
  claim = claim_of(Quantity::position);
  EXPECT_EQ(core::no_interval(claim), "");
  claim.reduction = core::Reduction::rate;
  EXPECT_NE(core::no_interval(claim).find("measure: 'rate'"), std::string::npos);
  claim = claim_of(Quantity::position);
  claim.tolerance.relative = 1e-3;
  EXPECT_NE(core::no_interval(claim).find("tolerance: "), std::string::npos);
}

}  // namespace
}  // namespace cylon::validation
