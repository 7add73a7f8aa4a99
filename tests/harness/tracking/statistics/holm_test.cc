#include "harness/tracking/statistics/holm.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

namespace cylon::statistics {
namespace {

// Worked by hand: sorted .005 .01 .03 .04, times 4 3 2 1 is .02 .03 .06 .04, made monotone .02 .03 .06 .06.
TEST(Holm, WorkedByHand) {
  const std::vector<double> expected = {0.03, 0.06, 0.06, 0.02};
  const double p[] = {0.01, 0.04, 0.03, 0.005};
  const std::vector<double> adjusted = holm(p);
  ASSERT_EQ(adjusted.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_DOUBLE_EQ(adjusted[i], expected[i]) << i;
}

TEST(Holm, Edges) {
  EXPECT_TRUE(holm({}).empty());
  const double one[] = {0.3}, ties[] = {0.02, 0.02, 0.9}, sure[] = {1, 0, 1};
  EXPECT_EQ(holm(one), (std::vector<double>{0.3}));
  EXPECT_EQ(holm(ties), (std::vector<double>{0.06, 0.06, 0.9}));
  EXPECT_EQ(holm(sure), (std::vector<double>{1, 0, 1}));
  for (const double bad : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    const double p[] = {0.5, bad};
    EXPECT_THROW(holm(p), std::invalid_argument);
  }
}

// Its claim: over 40 true hypotheses, one of them wrongly refused with probability <= 5 %.  4000 trials have
// a deviation of sqrt(4000 .05 .95) = 14; 4 of it are allowed.  Without it (the negative control) nearly all
// trials refuse one, and with 20 plainly false hypotheses among the 40 it refuses these all the same.
TEST(Holm, HoldsTheFamily) {
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> uniform(0, 1);
  int held = 0, naive = 0, found = 0, mixed = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    std::vector<double> p(40);
    for (double& one : p) one = uniform(random);
    bool any = false, bare = false, wrong = false;
    for (const double adjusted : holm(p)) any |= adjusted <= 0.05;
    for (const double one : p) bare |= one <= 0.05;
    for (std::size_t i = 0; i < 20; ++i) p[i] *= 1e-6;
    const std::vector<double> adjusted = holm(p);
    for (std::size_t i = 0; i < 20; ++i) found += adjusted[i] <= 0.05 ? 1 : 0;
    for (std::size_t i = 20; i < 40; ++i) wrong |= adjusted[i] <= 0.05;
    held += any ? 1 : 0, naive += bare ? 1 : 0, mixed += wrong ? 1 : 0;
  }
  EXPECT_LE(held, 200 + 4 * 14);
  EXPECT_LE(mixed, 200 + 4 * 14);
  EXPECT_GT(naive, 3000);
  EXPECT_EQ(found, 4000 * 20);
}

}  // namespace
}  // namespace cylon::statistics
