// Claims by theory on an oscillator whose errors are known: who keeps a promise passes, who breaks it does
// not.
#include "harness/study/theory.h"

#include "harness/study/runner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

namespace cylon::study {
namespace {

constexpr double rate = 10, amplitude = 0.7;

// x = A cos W t, which a spring of no rest length makes.
scenario::Scenario oscillator(const std::string& theory = "") {
  return scenario::parse(
      "duration = 1.0\nstep = \"1/1024\"\n[[body]]\nname = \"bob\"\nmass = 2\nposition = [0.7, 0, 0]\n"
      "[[spring]]\nbody = \"bob\"\npin = [0, 0, 0]\nstiffness = 200\n"
      "[theory]\nrate = 10\nreason = \"sqrt(k / m)\"\n" +
          theory +
          "[[claim]]\nfollows = \"spring_zero_length\"\nobservable = \"position\"\n"
          "tolerance = { relative = 1e-3, reason = \"r\" }\n"
          "[[claim]]\nchanges = \"position\"\nat_least = 0.1\ntolerance = { absolute = 0.01, reason = \"r\" "
          "}\n",
      "oscillator.toml");
}

struct Promises {
  int order = 2;
  std::string tolerance;           // empty: of fixed steps
  std::string name = "tolerance";  // of the setting
  std::string precision = "double";
};

// An engine whose error is `size` h^power A sin W t, and what it says of itself.
std::map<std::string, TheoryFinding> judged(const Promises& says, double size, double power,
                                            const std::string& theory = "") {
  const scenario::Scenario cut = cut_to_theory(oscillator(theory));
  const auto run = [&](int k) {
    core::Recording recording;
    recording.dt = std::ldexp(cut.step, -k);
    recording.engine.precision = says.precision;
    recording.engine.integrators = {{"scheme", says.order, "", !says.tolerance.empty()}};
    recording.terms.integrator = "scheme", recording.terms.order = says.order;
    if (!says.tolerance.empty()) recording.terms.settings = {{says.name, says.tolerance, "", ""}};
    const auto steps = std::llround(cut.duration / recording.dt);
    for (std::int64_t n = 0; n <= steps; ++n) {
      const double t = static_cast<double>(n) * recording.dt;
      core::State state = core::initial_state(cut.scene);
      state[0].position.x() =
          amplitude * (std::cos(rate * t) + size * std::pow(recording.dt, power) * std::sin(rate * t));
      recording.steps.push_back(n), recording.states.push_back(state);
    }
    return recording;
  };
  std::map<std::string, TheoryFinding> result;
  for (const TheoryFinding& found : judge_by_theory(cut, cut.step, run)) result[found.claim] = found;
  return result;
}

constexpr const char* value = "theory: position follows spring_zero_length";
constexpr const char* order = "theory: order of position follows spring_zero_length";

bool kept(const TheoryFinding& found) { return found.measured <= found.allowed; }

TEST(Theory, BoundIsTheCompoundedErrorOfTheSteps) {
  const double h = 1.0 / 1024, x = std::pow(rate * h, 2) * rate;
  const auto found = judged({}, 1, 2);
  ASSERT_TRUE(found.contains(value));
  EXPECT_NEAR(found.at(value).allowed, 2 * amplitude * std::expm1(x), 1e-3 * 2 * amplitude * x)
      << "the range of cos is 2 A";
  EXPECT_NEAR(judged({}, 1, 2, "magnification = 7\n").at(value).allowed / found.at(value).allowed, 7, 1e-6);
  EXPECT_NE(found.at(value).reason.find("sqrt(k / m)"), std::string::npos);
  EXPECT_EQ(found.size(), 2u) << "a least change is no error, and is not judged";
}

TEST(Theory, HoldsEachToItsOwnPromise) {
  // 50 h^2 and 5 h: both far below a thousandth, and the second one is no second order.
  EXPECT_TRUE(kept(judged({.order = 2}, 50, 2).at(value)));
  EXPECT_TRUE(kept(judged({.order = 2}, 50, 2).at(order)));
  EXPECT_TRUE(kept(judged({.order = 1}, 5, 1).at(value)));
  EXPECT_TRUE(kept(judged({.order = 1}, 5, 1, "until = 0.25\n").at(order)));
  EXPECT_FALSE(kept(judged({.order = 2}, 5, 1).at(value)));
  EXPECT_FALSE(kept(judged({.order = 2}, 0.1, 1).at(order))) << "small, and falls too slowly";
  EXPECT_FALSE(kept(judged({.order = 4}, 5, 2).at(value)));
}

TEST(Theory, OrderIsNotAskedWhereItDoesNotShow) {
  EXPECT_FALSE(judged({.order = 4}, 1e-13, 0).contains(order)) << "rounding";
  EXPECT_FALSE(judged({.order = 2}, 50, 2, "forces = \"kinked\"\n").contains(order));
  EXPECT_FALSE(judged({.order = 2}, 5, 1, "forces = \"jumping\"\n").contains(order));
  EXPECT_TRUE(kept(judged({.order = 2}, 5, 1, "forces = \"jumping\"\n").at(value))) << "first order there";
}

TEST(Theory, HoldsABoundedErrorToTenTimesItsBound) {
  const auto allowed = [](const std::string& name) {
    return judged({.order = 8, .tolerance = "1e-6", .name = name}, 0, 1).at(value).allowed;
  };
  EXPECT_NEAR(allowed("tolerance"), 10 * 1e-6 * 2 * amplitude, 1e-9);
  EXPECT_NEAR(allowed("tolerance of a step"), 10 * 1e-6 * 2 * amplitude * rate, 1e-8);
  EXPECT_FALSE(kept(judged({.order = 8, .tolerance = "1e-6"}, 3e-5, 0).at(value)));
  EXPECT_TRUE(kept(judged({.order = 8, .tolerance = "1e-6"}, 1e-5, 0).at(value)));
  EXPECT_FALSE(judged({.order = 8, .tolerance = "1e-6"}, 1e-5, 0).contains(order));
}

TEST(Theory, AllowsTheRoundingOfThePrecision) {
  EXPECT_FALSE(kept(judged({.order = 8}, 1e-6, 0).at(value)));
  EXPECT_TRUE(kept(judged({.order = 8, .precision = "float"}, 1e-6, 0).at(value)));
}

// A bound as large as the motion lets an engine pass that stands still.
TEST(Theory, SaysWhereItBoundsNothing) {
  EXPECT_TRUE(judged({.order = 2}, 1, 2).at(value).binds);
  EXPECT_FALSE(judged({.order = 2}, 1, 2, "magnification = 1e7\n").at(value).binds);
  EXPECT_FALSE(judged({.order = 8, .tolerance = "0.1"}, 0, 0).at(value).binds);
}

TEST(Theory, TolerancesThatAreNoNumberAreAFailureOfTheWorker) {
  for (const char* tolerance : {"tight", "1e-6x", "-1", "0", "nan", "inf", "1e999"}) {
    try {
      judged({.order = 8, .tolerance = tolerance}, 0, 0);
      ADD_FAILURE() << tolerance;
    } catch (const RunFailed& failed) {
      EXPECT_EQ(failed.outcome.status, results::Status::protocol);
      EXPECT_NE(failed.outcome.reason.find(tolerance), std::string::npos) << failed.outcome.reason;
    }
  }
}

TEST(Theory, GoesAsFarAsItsScenarioSays) {
  const scenario::Scenario cut = cut_to_theory(oscillator("until = 0.25\n"));
  EXPECT_EQ(cut.duration, 0.25);
  ASSERT_EQ(cut.claims.size(), 1u);
  EXPECT_EQ(cut.claims[0].until, 0.25);
  EXPECT_LT(judged({}, 1, 2, "until = 0.25\n").at(value).allowed, judged({}, 1, 2).at(value).allowed);
}

}  // namespace
}  // namespace cylon::study
