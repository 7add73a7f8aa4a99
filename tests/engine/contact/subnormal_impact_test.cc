// A body at rest that came to its stop with 1e-319 m/s was "solved iteratively, not to rounding: off by up to 0 m/s": rounding as
// a part of such a number is 0, and no solution was within it.
#include "engine/contact/coulomb.h"

#include <gtest/gtest.h>

#include <limits>

namespace cylon::engine {
namespace {

TEST(SubnormalImpact, IsSolvedToRounding) {
  for (const Real speed : {Real(2.36341e-319), Real(4.9e-324), Real(1e-300), Real(1e-3)}) {
    CoulombProblem p;
    p.response = MatrixX::Zero(3, 3);
    p.response(0, 0) = Real(0.729927);
    p.offset = VectorX::Zero(3);
    p.offset[0] = -speed;
    p.friction = {0}, p.bound = {0}, p.pair = {0}, p.hold.resize(1);
    const CoulombSolution solution = solve(p);
    EXPECT_TRUE(solution.exact) << speed;
    EXPECT_EQ(solution.violation, 0) << speed;
    EXPECT_NEAR(solution.force[0], speed / Real(0.729927), 1e-15 * speed + std::numeric_limits<Real>::min())
        << speed;
  }
}

}  // namespace
}  // namespace cylon::engine
