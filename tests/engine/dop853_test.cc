// Error control, dense output and exits of the adaptive integrator.
#include "engine/integrators/dop853.h"

#include "tests/engine/scheme_systems.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <type_traits>

namespace cylon::engine {
namespace {

/// y'' = -w^2 y about three frequencies: the exact motion is known.
struct Oscillators {
  std::array<Real, 3> frequency{1.0, 1.7, 2.3};
  std::size_t size() const { return 6; }
  void rates(Time, const Real* from, Real* rate) {
    for (std::size_t i = 0; i < 3; ++i) {
      rate[i] = from[3 + i];
      rate[3 + i] = -frequency[i] * frequency[i] * from[i];
    }
  }
  void kick(Time, Real h, Real* y) {
    for (std::size_t i = 0; i < 3; ++i) y[3 + i] -= h * frequency[i] * frequency[i] * y[i];
  }
  void drift(Real h, Real* y) {
    for (std::size_t i = 0; i < 3; ++i) y[i] += h * y[3 + i];
  }
  void project(Real*) {}

  std::vector<Real> exact(double t) const {
    std::vector<Real> y(6);
    for (std::size_t i = 0; i < 3; ++i) {
      y[i] = std::cos(frequency[i] * t);
      y[3 + i] = -frequency[i] * std::sin(frequency[i] * t);
    }
    return y;
  }
};

/// One equation y' = f(t, y) on an otherwise idle state.
template <class F>
struct Single {
  F f;
  std::size_t size() const { return 1; }
  void rates(Time t, const Real* from, Real* rate) { rate[0] = f(t, from[0]); }
  void kick(Time, Real, Real*) {}
  void drift(Real, Real*) {}
  void project(Real*) {}
};
template <class F>
Single(F) -> Single<F>;

template <System S>
struct Result {
  std::vector<Real> y;
  long evaluations;
};

template <System S>
Result<S> solve(S system, std::vector<Real> y, double tolerance, double duration) {
  Dop853<S> integrator(y.size(), tolerance);
  EXPECT_EQ(integrator.advance(system, 0, duration, y.data()), Ending::done);
  EXPECT_EQ(integrator.end(), duration);
  EXPECT_EQ(integrator.evaluations(), 2 + 12 * integrator.accepted() + 11 * integrator.rejected());
  return {y, integrator.evaluations()};
}

// The error follows the tolerance: over eight decades the fitted power is 1, within 0.15 (section II.10 of
// the book finds the same for error per step, a little less than 1 over few steps).
template <System S>
void expect_proportional(const S& system, const std::vector<Real>& start, const std::vector<Real>& exact,
                         double duration) {
  const auto error = [&](double tolerance) {
    return distance(solve(system, start, tolerance, duration).y, exact);
  };
  const double loose = (error(1e-4) + error(2e-4) + error(5e-4)) / 3;
  const double tight = (error(1e-11) + error(2e-11) + error(5e-11)) / 3;
  std::cout << "error at 1e-4: " << loose << ", at 1e-11: " << tight << "\n";
  EXPECT_NEAR(std::log10(loose / tight) / 7, 1, 0.15);
}

TEST(Dop853, ItsErrorIsProportionalToTheTolerance) {
  SpringPoint spring;
  std::vector<Real> exact = SpringPoint::start();
  Advance<SpringPoint>(*find_integrator("rk8"), 6).run(spring, 0, 10.0 / 4000, exact.data(), 4000);
  expect_proportional(SpringPoint{}, SpringPoint::start(), exact, 10);

  TiedBody body;
  exact = TiedBody::start();
  Advance<TiedBody>(*find_integrator("rk8"), 7).run(body, 0, 10.0 / 4000, exact.data(), 4000);
  expect_proportional(TiedBody{}, TiedBody::start(), exact, 10);
}

// 1000 s of up to 366 periods at 1e-14: what compensation is for.  The rounding of the rates alone, one part
// in 2^53 of each step's change, random, leaves 1e-16 x sqrt(steps) x the phase's growth with time.
TEST(Dop853, RoundingDoesNotGrowOverManySteps) {
  const Oscillators system;
  const double t = 1000;
  const Result<Oscillators> tight = solve(system, system.exact(0), 1e-14, t);
  const double error = distance(tight.y, system.exact(t));
  std::cout << "after " << t << " s at 1e-14: " << error << "\n";
  EXPECT_LT(error, 1e-11);  // 1e-14 a step, 2000 steps of which half a percent keep their sign
  EXPECT_GT(distance(solve(system, system.exact(0), 1e-6, t).y, system.exact(t)), 1e-6);
}

TEST(Dop853, KeepsLongMotionsOfABody) {
  TiedBody body;
  body.swing.setZero();
  std::vector<Real> y = TiedBody::start();
  const Real energy = body.energy(y.data());
  y = solve(body, y, 1e-13, 200).y;
  EXPECT_NEAR(body.energy(y.data()) / energy, 1, 1e-10);  // 1e-13 x some 1000 steps
  EXPECT_NEAR(TiedBody::orientation(y.data()).norm(), 1, 10 * std::numeric_limits<Real>::epsilon());
}

/// Oscillators whose rates come with an error of 1e-9 that the last bits of the state decide.
struct Noisy : Oscillators {
  void rates(Time t, const Real* from, Real* rate) {
    Oscillators::rates(t, from, rate);
    for (std::size_t i = 0; i < 6; ++i) {
      std::uint64_t bits = std::bit_cast<std::uint64_t>(static_cast<double>(from[(i + 1) % 6])) + i;
      bits = (bits ^ (bits >> 31)) * 0x9e3779b97f4a7c15u;
      bits = (bits ^ (bits >> 29)) * 0xbf58476d1ce4e5b9u;
      rate[i] += Real(1e-9) * (static_cast<Real>(bits >> 11) * Real(0x1p-52) - 1);
    }
  }
};

template <class S>
Result<S> solve_rounded(S system, double tolerance, double duration, bool takes, long most) {
  std::vector<Real> y = system.exact(0);
  Dop853<S> integrator(6, tolerance);
  if (takes) integrator.take_rounding();
  integrator.start(system, 0, y.data());
  bool rounded = false;
  while (integrator.end() < duration && integrator.evaluations() < most) {
    EXPECT_EQ(integrator.step(system, duration), Ending::done);
    rounded = rounded || integrator.rounded();
  }
  EXPECT_EQ(rounded, (takes && std::is_same_v<S, Noisy>));
  std::copy_n(integrator.state(), 6, y.data());
  return {y, integrator.evaluations()};
}

// Steps shrank until rounding of the rates was below the tolerance: 10^5 times as many, for the same error.
TEST(Dop853, StepsDoNotShrinkForRoundingOfTheRates) {
  const Result<Noisy> free = solve_rounded(Noisy{}, 1e-13, 10, true, 1'000'000);
  EXPECT_LT(free.evaluations, 3000);
  const double error = distance(free.y, Noisy{}.exact(10));
  std::cout << free.evaluations << " evaluations, error " << error << "\n";
  EXPECT_LT(error, 3e-8);  // 10 s at rates that are off by up to 1e-9, in six numbers
  EXPECT_EQ(solve_rounded(Noisy{}, 1e-13, 10, false, 1'000'000).evaluations / 1000, 1000);
}

// Of well-conditioned rates nothing is taken, at any tolerance: the same bits.
TEST(Dop853, WellConditionedRatesKeepTheTolerance) {
  for (const double tolerance : {1e-6, 1e-10, 1e-14, 1e-17}) {
    const auto one = solve_rounded(Oscillators{}, tolerance, 30, false, 1'000'000),
               other = solve_rounded(Oscillators{}, tolerance, 30, true, 1'000'000);
    EXPECT_EQ(one.y, other.y) << tolerance;
    EXPECT_GE(other.evaluations, one.evaluations);  // what is measured
  }
}

// One step of h: the dense output's error falls by 2^8 when h halves (order 7), at every place inside it.
TEST(Dop853, DenseOutputHasOrderSeven) {
  Oscillators system;
  const auto error = [&](double h, double place) {
    Dop853<Oscillators> integrator(6, Real(1e3));  // whatever h is, it is accepted
    integrator.start(system, 0, system.exact(0).data(), h);
    EXPECT_EQ(integrator.step(system, h), Ending::done);
    EXPECT_EQ(integrator.end(), h);
    std::vector<Real> y(6);
    integrator.at(system, place * h, y.data());
    return distance(y, system.exact(place * h));
  };
  for (const double place : {0.1, 0.35, 0.5, 0.8})
    EXPECT_NEAR(std::log2(error(0.4, place) / error(0.2, place)), 8, 0.35) << place;
}

TEST(Dop853, DenseOutputIsContinuous) {
  SpringPoint system;
  Dop853<SpringPoint> integrator(6, 1e-9);
  integrator.start(system, 0, SpringPoint::start().data());
  std::vector<Real> before = SpringPoint::start(), y(6);
  SpringPoint other;
  std::vector<Real> exact = SpringPoint::start();
  Advance<SpringPoint> fine(*find_integrator("rk8"), 6);
  double time = 0;
  while (integrator.end() < 3) {
    ASSERT_EQ(integrator.step(system, 1e9), Ending::done);
    integrator.at(system, integrator.begin(), y.data());
    EXPECT_LT(distance(y, before), 1e-15);
    integrator.at(system, integrator.end(), y.data());
    EXPECT_LT(distance(y, std::vector<Real>(integrator.state(), integrator.state() + 6)), 1e-15);
    before = y;
    for (const double place : {0.2, 0.5, 0.9}) {
      const double t = integrator.begin() + place * (integrator.end() - integrator.begin());
      integrator.at(system, t, y.data());
      fine.run(other, time, (t - time) / 50, exact.data(), 50);
      time = t;
      EXPECT_LT(distance(y, exact), 1e-6)
          << t;  // h^8 where the steps keep h^9 below 1e-9: 30 to 300 times more
    }
  }
}

TEST(Dop853, SplitCallsReachTheirEndTimesExactly) {
  SpringPoint system;
  Dop853<SpringPoint> integrator(6, 1e-10);
  std::vector<Real> y = SpringPoint::start();
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(integrator.advance(system, i * 0.1, (i + 1) * 0.1, y.data()), Ending::done);
    EXPECT_EQ(integrator.end(), (i + 1) * 0.1);
  }
  EXPECT_LT(distance(y, solve(SpringPoint{}, SpringPoint::start(), 1e-10, 10).y), 1e-8);
  EXPECT_LE(integrator.accepted(), 2 * 100 + 100);  // its own steps are longer than 0.05
  // it went on: no rates were taken twice at a step's two ends
  EXPECT_EQ(integrator.evaluations(), 2 + 12 * integrator.accepted() + 11 * integrator.rejected());

  y[3] = -y[3];  // an impact: starts anew, with the step that it had
  const long evaluations = integrator.evaluations(), attempts = integrator.accepted() + integrator.rejected();
  ASSERT_EQ(integrator.advance(system, 100 * 0.1, 10.05, y.data()), Ending::done);
  EXPECT_LE(integrator.evaluations() - evaluations,
            1 + 12 * (integrator.accepted() + integrator.rejected() - attempts));
}

TEST(Dop853, FailsWhenNoStepIsSmallEnough) {
  Single explosion{[](Time, Real y) { return y * y; }};  // 1/(1 - t)
  Dop853<decltype(explosion)> integrator(1, 1e-10);
  Real y = 1;
  const Ending outcome = integrator.advance(explosion, 0, 2, &y);
  EXPECT_NE(outcome, Ending::done);
  EXPECT_NEAR(integrator.end(), 1, 1e-6);
  EXPECT_LT(integrator.evaluations(), 100000);
}

TEST(Dop853, FailsOnNonFiniteRates) {
  Single hole{[](Time t, Real) { return t > 1 ? std::numeric_limits<Real>::quiet_NaN() : Real(1); }};
  Dop853<decltype(hole)> integrator(1, 1e-10);
  Real y = 0;
  EXPECT_EQ(integrator.advance(hole, 0, 2, &y), Ending::non_finite);
  EXPECT_NEAR(integrator.end(), 1, 1e-10);
  EXPECT_NEAR(y, integrator.end(), 1e-15);

  Single nothing{[](Time, Real) { return std::numeric_limits<Real>::quiet_NaN(); }};
  Dop853<decltype(nothing)> never(1, 1e-10);
  EXPECT_EQ(never.advance(nothing, 0, 2, &y), Ending::non_finite);
}

TEST(Dop853, RestTakesOneStep) {
  Single rest{[](Time, Real) { return Real(0); }};
  Dop853<decltype(rest)> integrator(1, 1e-10);
  Real y = 3;
  EXPECT_EQ(integrator.advance(rest, 0, 1e6, &y), Ending::done);
  EXPECT_EQ(y, 3);
  EXPECT_EQ(integrator.accepted(), 1);
}

// A jump in the forces is stepped over at the tolerance, by rejected steps.
TEST(Dop853, LocatesDiscontinuity) {
  Single jump{[](Time t, Real) { return t < 0.37 ? Real(1) : Real(-2); }};
  Dop853<decltype(jump)> integrator(1, 1e-9);
  Real y = 0.1;
  EXPECT_EQ(integrator.advance(jump, 0, 1, &y), Ending::done);
  EXPECT_NEAR(y, 0.1 + 0.37 - 2 * 0.63, 1e-7);
  EXPECT_GT(integrator.rejected(), 3);
}

// The System's own scales: where it says that an error of 1 matters no more than one of 1e-6 elsewhere, steps
// grow by a factor up to 1e6^(1/8) = 5.6.
struct Scaled : Oscillators {
  Real unit = 1;
  void scales(const Real*, Real* scale) const { std::fill_n(scale, 6, unit); }
};

TEST(Dop853, UsesScalesOfTheSystem) {
  Scaled coarse, fine;
  coarse.unit = 1e6;
  const long few = solve(coarse, coarse.exact(0), 1e-9, 50).evaluations;
  const long many = solve(fine, fine.exact(0), 1e-9, 50).evaluations;
  EXPECT_GT(many, 3 * few);
  EXPECT_LT(many, 6 * few);
}

// Less than rounding cannot be asked for: it is answered with what can be, and with an end.
TEST(Dop853, TightestToleranceEnds) {
  const Oscillators system;
  const Result<Oscillators> result = solve(system, system.exact(0), 1e-30, 20);
  EXPECT_LT(distance(result.y, system.exact(20)), 1e-13);
  EXPECT_LT(result.evaluations, 20000);
}

// A number whose errors do not count, as turns that are counted, on which rates depend.  Rounding of the rates was measured with
// one that was larger by 1e30 epsilon, so that a limit was somewhere else, and any error was rounding.
struct Counted {
  double largest = 0;
  std::size_t size() const { return 2; }
  void rates(Time t, const Real* y, Real* rate) {
    largest = std::max(largest, static_cast<double>(std::abs(y[0])));
    rate[0] = 0, rate[1] = std::cos(static_cast<Real>(t)) * (1 + y[0]);
  }
  void project(Real*) {}
  void scales(const Real*, Real* scale) const { scale[0] = uncontrolled, scale[1] = 1; }
};

TEST(Dop853, MeasuresRoundingWithNumbersThatDoNotCountAsTheyAre) {
  Counted counted;
  Dop853<Counted> integrator(2, 1e-13);
  integrator.take_rounding();
  Real y[2] = {2, 0};
  ASSERT_EQ(integrator.advance(counted, 0, 1, y), Ending::done);
  EXPECT_LE(counted.largest, 2.001);
  EXPECT_NEAR(y[1], 3 * std::sin(Real(1)), 1e-12);
}

}  // namespace
}  // namespace cylon::engine
