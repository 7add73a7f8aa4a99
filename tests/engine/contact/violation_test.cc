// How far forces at contacts are from Coulomb's and Signorini's laws: zero for solutions, and the velocity that is wrong
// for what is none.
#include "engine/contact/coulomb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace cylon::engine {
namespace {

CoulombProblem one_point(Real response, const Vector3& offset, Real friction) {
  CoulombProblem p;
  p.response = response * MatrixX::Identity(3, 3);
  p.offset = offset;
  p.friction = {friction};
  p.pair = {0};
  p.hold.resize(1);
  return p;
}

// A point of response 2: u = 2 f + q.
TEST(Violation, IsTheWrongVelocityOfOnePoint) {
  const struct {
    Vector3 offset, force;
    Real friction, violation;
  } cases[] = {
      {{3, 1, 0}, {0, 0, 0}, Real(0.5), 0},                               // parts
      {{-3, 0, 0}, {0, 0, 0}, Real(0.5), 3},                              // enters at 3 m/s
      {{-3, 0, 0}, {2, 0, 0}, 0, 1},                                      // pushed out at 1 m/s
      {{3, 0, 0}, {Real(-0.25), 0, 0}, 0, Real(0.5)},                     // pulls: the force ought to be 0
      {{-3, 1, 0}, {Real(1.5), Real(-0.5), 0}, Real(0.5), 0},             // sticks
      {{-3, 10, 0}, {Real(1.5), Real(-0.75), 0}, Real(0.5), 0},           // slides
      {{-3, 10, 0}, {Real(1.5), 0, 0}, Real(0.5), std::sqrt(Real(1.8))},  // slides and is not rubbed
  };
  for (const auto& c : cases)
    EXPECT_NEAR(violation(one_point(2, c.offset, c.friction), c.force), c.violation, 1e-14)
        << c.offset.transpose();
  EXPECT_EQ(violation(one_point(2, {-3, 0, 0}, 1), Vector3(std::numeric_limits<Real>::quiet_NaN(), 0, 0)),
            std::numeric_limits<Real>::infinity());
}

// A slip that is given asks for friction against itself, whatever the rates are.
TEST(Violation, KnowsGivenSlips) {
  CoulombProblem p = one_point(2, {-3, 0, 0}, Real(0.5));
  p.hold[0] = {Grip::slides, {0, 1}, true};
  EXPECT_NEAR(violation(p, Vector3(Real(1.5), 0, Real(-0.75))), 0, 1e-14);
  EXPECT_NEAR(violation(p, Vector3(Real(1.5), Real(-0.75), 0)), 2 * Real(0.75) * std::sqrt(Real(2)), 1e-14);
}

// Random problems of four points: solutions obey the law to rounding, and a change of them is seen in its own size.
TEST(Violation, VanishesForSolutionsAlone) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  int solved = 0;
  for (int trial = 0; trial < 200; ++trial) {
    constexpr int points = 4;
    CoulombProblem p;
    MatrixX root(3 * points, 3 * points);
    for (Eigen::Index i = 0; i < root.size(); ++i) root.data()[i] = static_cast<Real>(normal(random));
    p.response = root * root.transpose() + MatrixX::Identity(3 * points, 3 * points);
    p.offset.resize(3 * points);
    for (Eigen::Index i = 0; i < p.offset.size(); ++i) p.offset[i] = static_cast<Real>(3 * normal(random));
    p.friction = {0, Real(0.1), Real(0.3), Real(0.5)};
    p.pair = {0, 1, 2, 3};
    p.hold.resize(points);
    const CoulombSolution solution = solve(p);
    const Real found = violation(p, solution.force);
    if (!solution.exact) {
      EXPECT_EQ(solution.violation, found);
      continue;
    }
    ++solved;
    EXPECT_EQ(solution.violation, 0);
    EXPECT_LT(found, 1e-10) << trial;
    VectorX off = solution.force;
    off[0] += Real(1e-3);
    EXPECT_GT(violation(p, off), 1e-4) << trial;
  }
  EXPECT_GT(solved, 190);
}

}  // namespace
}  // namespace cylon::engine
