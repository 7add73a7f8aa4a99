// Bands of predictions that were made with fitted parameters: they hold what the fit leaves open.  Throws of a ball that can be
// written down (ball_world.h), of which the true parameters are known.
#include "harness/validation/band.h"

#include "harness/tracking/statistics/bootstrap.h"
#include "harness/validation/curves.h"
#include "harness/validation/fit.h"
#include "harness/validation/normal.h"
#include "harness/validation/score.h"
#include "harness/validation/split.h"
#include "harness/validation/synthetic.h"
#include "tests/levels/ball_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace cylon::validation {
namespace {

using measured::Experiment;

// Throws with their noise, of the parameters that are true.
Experiment seen(int count, std::uint64_t seed, const std::vector<double>& truth = ball_world::truth()) {
  const Experiment e = ball_world::throws(count, seed);
  std::vector<std::size_t> runs(e.runs.size());
  std::iota(runs.begin(), runs.end(), 0);
  return synthetic(e, runs, truth, ball_world::world(), seed);
}

Fitted without_covariance(Fitted fitted) {
  fitted.factor.resize(fitted.factor.rows(), 0);
  return fitted;
}

// The draws of one band hold more or less than 95 % of all motions; each experiment has a band of its own.
double share(const Experiment& e, std::size_t run, const Fitted& fitted, std::uint64_t seed) {
  return score(e, run, ball_world::world(), {.members = 39, .seed = seed}, fitted).covered;
}

// Each experiment has parameters of its own, drawn from the covariance that the band is given.
TEST(FittedBand, HoldsDrawsOfTheCovarianceThatItIsGiven) {
  Fitted fitted;
  fitted.parameters = ball_world::throws(1, 1).parameters, fitted.values = ball_world::truth();
  // Friction and length err together.
  Eigen::Matrix4d factor = Eigen::Vector4d(0.006, 0.02, 0.05, 0.004).asDiagonal();
  factor(3, 0) = 0.003;
  fitted.factor = factor;
  std::vector<double> with, without;
  for (std::uint64_t k = 0; k < 200; ++k) {
    Normal normal(k, 0, 0);
    const Eigen::Vector4d drawn = factor * Eigen::Vector4d::NullaryExpr([&] { return normal(1); });
    std::vector<double> truth = fitted.values;
    for (std::size_t j = 0; j < truth.size(); ++j) truth[j] += drawn[static_cast<Eigen::Index>(j)];
    const Experiment e = seen(1, 1000 + k, truth);
    with.push_back(share(e, 0, fitted, k)), without.push_back(share(e, 0, without_covariance(fitted), k));
  }
  const Estimate right = covered(with);
  EXPECT_EQ(band_answer(right), Answer::inside)
      << right.value << " " << right.interval.low << " " << right.interval.high;
  EXPECT_EQ(band_answer(covered(without)), Answer::outside) << covered(without).value;
}

// The whole way: four throws are fitted, and the band of two others has the covariance that this fit has found.  Runs of one
// experiment share its fit, so that an experiment counts as one; experiments are independent, and the interval is that of their mean.
TEST(FittedBand, AfterAFitHoldsRunsThatItDidNotSee) {
  constexpr std::uint64_t experiments = 100;
  std::vector<double> with, without;
  for (std::uint64_t k = 0; k < experiments; ++k) {
    const Experiment e = seen(6, 5000 + k);
    Likelihood likelihood(e, e.parameters, {0, 1, 2, 3}, ball_world::world(), 1);
    const Fit found = fit(likelihood);
    const Fitted fitted{e.parameters, found.values, factor_of(found.known.covariance)};
    const auto mean = [&](const Fitted& by) { return (share(e, 4, by, k) + share(e, 5, by, k)) / 2; };
    with.push_back(mean(fitted)), without.push_back(mean(without_covariance(fitted)));
  }
  const double mean = statistics::mean(with);
  double square = 0;
  for (const double one : with) square += (one - mean) * (one - mean);
  const double half = 1.96 * std::sqrt(square / (experiments - 1) / experiments);
  EXPECT_EQ(answer({mean - half, mean + half}, 0.90, 0.98), Answer::inside) << mean << " +- " << half;
  EXPECT_LT(statistics::mean(without), mean) << "parameters must matter here";
}

// What a surface is said to be counts no more once it is fitted.
TEST(FittedBand, TakesFittedSurfacesFromTheFitAlone) {
  Experiment e = seen(1, 7);
  e.model.scene.materials[0].friction = ball_world::friction;  // little enough to slip
  const Fitted none{}, friction{{e.parameters[0]}, {ball_world::friction}, Eigen::MatrixXd(1, 0)};
  const Band band{.members = 9};
  const auto width = [&](const Fitted& fitted) {
    const Range r = range(e, 0, ball_world::world(), band, fitted);
    return (r.high - r.low).norm();
  };
  const double sure = width(friction), sure_too = width(none);
  e.material.friction = 0.05;
  EXPECT_EQ(width(friction), sure);
  EXPECT_GT(width(none), 1.05 * sure_too);
}

// Of surfaces that are known to a deviation alone each run has its own, and a band that is told so holds what it should.
TEST(FittedBand, HoldsRunsWithSurfacesOfTheirOwn) {
  std::vector<double> drawn, exact;
  for (std::uint64_t k = 0; k < 400; ++k) {
    Experiment e = ball_world::throws(1, 7000 + k);
    e.parameters.clear();
    e.material = {.friction = 0.02, .restitution = 0.08};
    e.model.scene.materials[0] = core::Material{{"ball", "table"}, 0.5, 0.1};
    const auto covered = [&](Surfaces surfaces, const measured::MaterialError& told) {
      Experiment seen = synthetic(e, std::vector<std::size_t>{0}, {}, ball_world::world(), k, surfaces);
      seen.material = told;
      return score(seen, 0, ball_world::world(), {.seed = k}).covered;
    };
    drawn.push_back(covered(Surfaces::drawn, e.material)), exact.push_back(covered(Surfaces::drawn, {}));
  }
  EXPECT_EQ(band_answer(covered(drawn)), Answer::inside) << covered(drawn).value;
  EXPECT_EQ(band_answer(covered(exact)), Answer::outside) << covered(exact).value;
}

// Runs of which each has errors of a size of its own, as the discrepancy says: a band with it holds what it should, one without does not.
TEST(FittedBand, HoldsADiscrepancyThatIsStated) {
  std::vector<double> with, without;
  for (std::uint64_t k = 0; k < 600; ++k) {
    Experiment e = ball_world::throws(1, 3000 + k);
    e.fit.degrees = 2;
    Normal normal(k, 1, 1);
    const double factor = std::sqrt(2 / normal.chi_squared(2));
    Experiment wide = e;
    wide.start *= factor, wide.noise *= factor;
    e.runs = synthetic(wide, std::vector<std::size_t>{0}, ball_world::truth(), ball_world::world(), k).runs;
    const Fitted exact{e.parameters, ball_world::truth(), Eigen::MatrixXd(4, 0)};
    const auto covered = [&](bool discrepancy) {
      return score(e, 0, ball_world::world(), {.seed = k, .discrepancy = discrepancy}, exact).covered;
    };
    with.push_back(covered(true)), without.push_back(covered(false));
  }
  EXPECT_EQ(band_answer(covered(with)), Answer::inside) << covered(with).value;
  EXPECT_EQ(band_answer(covered(without)), Answer::outside) << covered(without).value;
}

TEST(Normals, ChiSquaredHasItsMoments) {
  for (const double freedom : {0.7, 1.0, 4.0, 30.0}) {
    Normal normal(5, 0, 0);
    double mean = 0, square = 0;
    constexpr int draws = 40000;
    for (int i = 0; i < draws; ++i) {
      const double x = normal.chi_squared(freedom);
      mean += x / draws, square += x * x / draws;
    }
    EXPECT_NEAR(mean, freedom, 5 * std::sqrt(2 * freedom / draws)) << freedom;
    EXPECT_NEAR(square - mean * mean, 2 * freedom, 0.1 * 2 * freedom) << freedom;
  }
}

// Members that differ in the factor of lengths start at one place of the data.
TEST(FittedBand, IsInLengthsOfTheData) {
  Experiment e = seen(1, 8);
  e.start.setZero(), e.noise = 0;
  const Fitted length{{e.parameters[3]}, {ball_world::length}, Eigen::MatrixXd::Constant(1, 1, 0.01)};
  const Range r = range(e, 0, ball_world::world(), {.members = 9}, length);
  const Eigen::MatrixXd data = curves(e, e.runs[0].states, e.runs[0].states.front());
  EXPECT_LT((r.low.row(0) - data.row(0)).norm() + (r.high.row(0) - data.row(0)).norm(), 1e-12);
  EXPECT_GT((r.high.row(30) - r.low.row(30)).minCoeff(), 0);
}

// A parameter is not drawn beyond its range: a negative friction would be none.
TEST(FittedBand, CutsDrawsAtTheRanges) {
  const Experiment e = seen(1, 9);
  const Fitted wide{{e.parameters[0]}, {e.parameters[0].low}, Eigen::MatrixXd::Constant(1, 1, 100)};
  const study::Runner world = [](const core::Scene& scene, double dt, std::int64_t steps,
                                 std::int64_t every) {
    EXPECT_GE(scene.materials[0].friction, 0.02);
    EXPECT_LE(scene.materials[0].friction, 0.3);
    return ball_world::ran({}, scene, dt, steps, every);
  };
  range(e, 0, world, {.members = 9}, wide);
}

TEST(FittedBand, RefusesWhatIsNoCovariance) {
  const Eigen::Matrix2d good{{4, 2}, {2, 1}};  // singular: one combination alone is open
  const Eigen::MatrixXd factor = factor_of(good);
  EXPECT_LT((factor * factor.transpose() - good).norm(), 1e-12);
  EXPECT_THROW(factor_of(Eigen::Matrix2d{{1, 2}, {0, 1}}), std::invalid_argument);
  EXPECT_THROW(factor_of(Eigen::Matrix2d{{1, 2}, {2, 1}}), std::invalid_argument);
  EXPECT_THROW(factor_of(Eigen::Matrix2d{{std::nan(""), 0}, {0, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace cylon::validation
