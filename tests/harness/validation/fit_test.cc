// Fits of synthetic experiments, of which the truth is known.
#include "harness/validation/fit.h"

#include "harness/core/input_error.h"
#include "harness/validation/split.h"
#include "harness/validation/synthetic.h"
#include "tests/levels/ball_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>

namespace cylon::validation {
namespace {

using measured::Experiment, measured::Parameter;

std::vector<std::size_t> all_runs(const Experiment& e) {
  std::vector<std::size_t> runs(e.runs.size());
  std::iota(runs.begin(), runs.end(), 0);
  return runs;
}

Experiment seen(int count, std::uint64_t seed) {
  const Experiment e = ball_world::throws(count, seed);
  return synthetic(e, all_runs(e), ball_world::truth(), ball_world::world(), seed);
}

Fit fitted(const Experiment& e, const ball_world::Fault& fault = {}, int jobs = 1,
           const Memory& memory = {}) {
  Likelihood likelihood(e, e.parameters, all_runs(e), ball_world::world(fault), jobs);
  return fit(likelihood, memory);
}

TEST(Fit, FindsTheParametersOfTheModelItself) {
  const Fit f = fitted(seen(10, 1));
  EXPECT_TRUE(f.settled);
  EXPECT_TRUE(f.known.blind.empty());
  const std::vector<double> truth = ball_world::truth();
  for (std::size_t j = 0; j < truth.size(); ++j) {
    EXPECT_NEAR(f.values[j], truth[j], 4 * f.known.error[j]);
    EXPECT_LT(f.known.error[j], 0.03);
    EXPECT_FALSE(f.at_bound[j]);
  }
  EXPECT_EQ(f.numbers, f.windows * 19 * 6);
  EXPECT_GT(misfit_tail(f), 1e-3);
}

TEST(Fit, IsTheSameForAnyNumberOfJobsAndGoesOnWhereItWas) {
  const Experiment e = seen(4, 3);
  std::map<std::pair<int, std::vector<double>>, double> kept;
  std::size_t asked = 0;
  const Memory memory{.find = [&](int round, std::span<const double> values) -> std::optional<double> {
                        ++asked;
                        const auto found = kept.find({round, {values.begin(), values.end()}});
                        return found == kept.end() ? std::nullopt : std::optional(found->second);
                      },
                      .found =
                          [&](const Evaluation& one) {
                            kept[{one.round, one.values}] = one.deviance;
                          }};
  const Fit first = fitted(e, {}, 1, memory), other = fitted(e, {}, 3);
  EXPECT_EQ(first.values, other.values);
  EXPECT_EQ(first.deviance, other.deviance);
  EXPECT_EQ(first.known.error, other.known.error);
  EXPECT_EQ(first.known.spread, other.known.spread);
  const std::size_t evaluations = kept.size(), half = evaluations / 2;
  while (kept.size() > half) kept.erase(std::prev(kept.end()));
  const Fit resumed = fitted(e, {}, 1, memory);
  EXPECT_EQ(resumed.values, first.values);
  EXPECT_EQ(kept.size(), evaluations);
  EXPECT_LT(resumed.predictions, first.predictions);
  EXPECT_GE(asked, evaluations + half);
}

// Mass and inertia act as their ratio alone, as nothing but the table and gravity pushes the ball.
TEST(Fit, SaysWhichCombinationCannotBeToldApart) {
  Experiment e = seen(6, 4);
  e.parameters = {
      {"mass", "mass", "", 0.5, 1, 1.5}, {"inertia", "inertia", "", 0.5, 1, 1.5}, e.parameters[0]};
  const Fit f = fitted(e);
  ASSERT_EQ(f.known.blind.size(), 1u);
  const Combination& blind = f.known.blind[0];
  EXPECT_NEAR(std::abs(blind.weights[0]), std::sqrt(0.5), 0.1);
  EXPECT_NEAR(std::abs(blind.weights[1]), std::sqrt(0.5), 0.1);
  EXPECT_GT(blind.weights[0] * blind.weights[1], 0);
  EXPECT_TRUE(std::isnan(f.known.error[0]));
  EXPECT_TRUE(std::isnan(f.known.error[1]));
  EXPECT_LT(f.known.error[2], 0.05);  // the others are known nevertheless
  EXPECT_EQ(interval(f.values[0], f.known.error[0]).low, -std::numeric_limits<double>::infinity());
}

TEST(Fit, OfOneParameterTakesTheOtherOptimiser) {
  Experiment e = seen(8, 5);
  e.model.scene.materials[0].friction = ball_world::friction;
  e.model.scene.bodies[0].inertia *= ball_world::inertia;
  e = measured::with_values(e, std::vector<Parameter>{e.parameters[3]},
                            std::vector<double>{ball_world::length});
  e.parameters = {e.parameters[1]};
  const Fit f = fitted(e);
  EXPECT_TRUE(f.settled);
  EXPECT_NEAR(f.values[0], ball_world::restitution, 4 * f.known.error[0]);
}

TEST(Fit, TellsWhyAWindowHasNoPrediction) {
  const Experiment e = seen(3, 6);
  const study::Runner breaks = [](const auto&...) -> core::Recording {
    process::RunOutcome outcome;
    outcome.reason = "it fell asleep";
    throw study::RunFailed{outcome};
  };
  int runs = 0;
  const study::Runner later = [&](const core::Scene& scene, double dt, std::int64_t steps,
                                  std::int64_t every) {
    return ++runs > 1000 ? breaks(scene, dt, steps, every) : ball_world::ran({}, scene, dt, steps, every);
  };
  for (const study::Runner& runner : {breaks, study::Runner(later)}) {
    Likelihood likelihood(e, e.parameters, all_runs(e), runner, 1);
    try {
      fit(likelihood);
      FAIL();
    } catch (const study::RunFailed& failed) {
      EXPECT_EQ(failed.outcome.reason, "it fell asleep");
    }
  }
  Experiment none = e;
  none.fit.horizon = 0;
  EXPECT_THROW(Likelihood(none, e.parameters, all_runs(e), ball_world::world(), 1), core::InputError);
  none = e, none.noise = 0;
  EXPECT_THROW(Likelihood(none, e.parameters, all_runs(e), ball_world::world(), 1), core::InputError);
  none = e, none.fit.horizon = 7;
  EXPECT_THROW(Likelihood(none, e.parameters, all_runs(e), ball_world::world(), 1), core::InputError);
  none = e, none.model.scene.forces.emplace_back(core::Drive{});
  EXPECT_THROW(Likelihood(none, e.parameters, all_runs(e), ball_world::world(), 1), core::InputError);
  core::Joint servo;
  servo.type = core::JointType::hinge;
  servo.angles.push_back({{.stiffness = 3, .target_amplitude = 0.2, .target_frequency = 4}});
  none = e, none.model.scene.joints = {servo};
  EXPECT_THROW(Likelihood(none, e.parameters, all_runs(e), ball_world::world(), 1), core::InputError);
}

// One run of which one coordinate is in another unit: a discrepancy keeps it from moving the fit.
TEST(Fit, WithADiscrepancyBearsAWildRun) {
  Experiment e = seen(8, 7);
  for (core::State& state : e.runs[0].states) state[0].position.x() *= 4;
  const Fit gauss = fitted(e);
  e.fit.degrees = 4;
  const Fit robust = fitted(e);
  const std::vector<double> truth = ball_world::truth();
  const auto off = [&](const Fit& f) {
    double most = 0;
    for (std::size_t j = 0; j < truth.size(); ++j)
      most = std::max(most, std::abs(f.values[j] - truth[j]) / robust.known.error[j]);
    return most;
  };
  EXPECT_LT(off(robust), 4);
  EXPECT_GT(off(gauss), 8);
  EXPECT_LT(misfit_tail(gauss), 1e-6);  // and the misfit says that something is wrong
}

TEST(Split, DealsRunsByTheirNames) {
  Experiment e = ball_world::throws(11, 1);
  const auto part = parts_of(e, 2);
  EXPECT_EQ(std::accumulate(part.begin(), part.end(), std::size_t{0}), 5u);
  std::reverse(e.runs.begin(), e.runs.end());
  auto back = parts_of(e, 2);
  std::reverse(back.begin(), back.end());
  EXPECT_EQ(part, back);
}

// Which runs are taken does not depend on the order of the table, halves of them stay halves, and more runs hold the fewer.
TEST(Split, TakesTheFirstRunsByTheirNames) {
  Experiment e = ball_world::throws(11, 1);
  const auto names = [](const Experiment& of) {
    std::set<std::string> all;
    for (const measured::Run& run : of.runs) all.insert(run.name);
    return all;
  };
  const Experiment six = with_runs(e, 6), four = with_runs(e, 4);
  const auto of_six = names(six), of_four = names(four);
  EXPECT_EQ(six.runs.size(), 6u);
  EXPECT_EQ(four.runs.size(), 4u);
  EXPECT_TRUE(std::includes(of_six.begin(), of_six.end(), of_four.begin(), of_four.end()));
  const auto all_parts = parts_of(e, 2), parts = parts_of(six, 2);
  for (std::size_t i = 0; i < six.runs.size(); ++i) {
    const auto at = std::ranges::find(e.runs, six.runs[i].name, &measured::Run::name) - e.runs.begin();
    EXPECT_EQ(parts[i], all_parts[static_cast<std::size_t>(at)]);
  }
  std::reverse(e.runs.begin(), e.runs.end());
  EXPECT_EQ(names(with_runs(e, 6)), of_six);
  EXPECT_EQ(with_runs(e, 100).runs.size(), 11u);
}

}  // namespace
}  // namespace cylon::validation
