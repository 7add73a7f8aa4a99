// The paired rule keeps its error rates, also on heavy-tailed noise.
#include "harness/tracking/statistics/paired_rule.h"

#include "harness/tracking/statistics/signed_rank.h"
#include "tests/harness/tracking/statistics/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>

namespace cylon::statistics {
namespace {

std::vector<int> doubled_ranks(int n) {
  std::vector<int> doubled;
  for (int rank = 1; rank <= n; ++rank) doubled.push_back(2 * rank);
  return doubled;
}

// A proof, not a sample: at a look the test refuses on the patterns of signs with p <= alpha_k, all 2^n are
// equally likely, and the probability to refuse at any of the looks is at most the sum over them.  The
// attained sizes are below alpha_k because W is a whole number.
TEST(PairedRule, LevelOverAllLooksByEnumeration) {
  const PairedRule rule;
  double shares = 0, attained = 0;
  for (const PairedRule::Look& look : rule.looks) {
    const SignedRankDistribution distribution(doubled_ranks(look.pairs));
    double size = 0;
    for (int w = 0; distribution.at_most(w) / look.share <= rule.alpha; w += 2)
      size = distribution.at_most(w);
    EXPECT_GT(size, 0) << "no sample of " << look.pairs << " pairs decides";
    attained += size, shares += look.share;
  }
  std::printf("[ measured ] P(wrong decision) <= %.5f\n", attained);
  EXPECT_NEAR(shares, 1, 1e-15);
  EXPECT_LE(attained, rule.alpha);
  EXPECT_GT(attained, 0.9 * rule.alpha);  // and it is not won by never deciding
}

// At the very edge, B slower by tau exactly, "regressed" is wrong.  20 000 comparisons with heavy tails: at
// most alpha, plus 4 deviations sqrt(20000 .01 .99) = 14.  The negative control tests at alpha at every look.
TEST(PairedRule, LevelOverAllLooksBySimulation) {
  const PairedRule rule;
  PairedRule greedy;
  for (PairedRule::Look& look : greedy.looks) look.share = 1;
  std::mt19937_64 random(23);
  int wrong = 0, wrong_greedy = 0;
  for (int trial = 0; trial < 8000; ++trial) {
    const std::vector<double> d = interleaved(noises()[1], 40, 1 + rule.tau, random);
    wrong += decide(d, rule).outcome == Outcome::regressed ? 1 : 0;
    wrong_greedy += decide(d, greedy).outcome == Outcome::regressed ? 1 : 0;
  }
  std::printf("[ measured ] wrong at the edge: %.2f %%; every look at the whole level: %.2f %%\n",
              wrong / 80.0, wrong_greedy / 80.0);
  EXPECT_LE(wrong, 80 + 4 * 9);
  EXPECT_GT(wrong_greedy, 160);
}

struct Tally {
  std::map<Outcome, int> count;
  double pairs = 0;

  void add(const PairedResult& result) { ++count[result.outcome], pairs += result.pairs; }
};

// 2000 comparisons of a program with itself, on each kind of noise: no false alarm and no false praise.  The
// negative control sees the same processes, A first and then B, one pair: the bare ratio above 1.1.
TEST(PairedRule, NoFalseAlarms) {
  for (const Noise& noise : noises()) {
    std::mt19937_64 random(29);
    Tally tally;
    int bare = 0;
    for (int trial = 0; trial < 2000; ++trial) {
      const std::vector<double> d = interleaved(noise, 40, 1, random);
      tally.add(decide(d));
      bare += d[0] > std::log(1.1) ? 1 : 0;
    }
    std::printf(
        "[ measured ] A/A, %s: %d regressed, %d improved, %d same, %d inconclusive, %.1f pairs; bare ratio "
        "%d alarms\n",
        noise.name, tally.count[Outcome::regressed], tally.count[Outcome::improved],
        tally.count[Outcome::same], tally.count[Outcome::inconclusive], tally.pairs / 2000, bare);
    EXPECT_EQ(tally.count[Outcome::regressed], 0) << noise.name;
    EXPECT_EQ(tally.count[Outcome::improved], 0) << noise.name;
    EXPECT_GT(bare, 0) << noise.name;
  }
}

// What it is for: 5 % in at least 80 of 100, 10 % in at least 90, on 3 % of noise per process.  "The same"
// within 2 % wants quieter processes: at 3 % the rule says inconclusive rather than a guess.
TEST(PairedRule, FindsSlowDowns) {
  struct Row {
    double spread, factor;
    Outcome outcome;
    double at_least;
  };
  const Row rows[] = {{0.03, 1.00, Outcome::inconclusive, 0.8}, {0.03, 1.05, Outcome::regressed, 0.8},
                      {0.03, 1.10, Outcome::regressed, 0.9},    {0.03, 1 / 1.05, Outcome::improved, 0.8},
                      {0.03, 1 / 1.10, Outcome::improved, 0.9}, {0.01, 1.00, Outcome::same, 0.95},
                      {0.01, 1.05, Outcome::regressed, 0.95}};
  for (const Row& row : rows) {
    std::mt19937_64 random(31);
    Tally tally;
    const Noise noise = {.name = "", .spread = row.spread};
    for (int trial = 0; trial < 2000; ++trial) tally.add(decide(interleaved(noise, 40, row.factor, random)));
    const double share = tally.count[row.outcome] / 2000.0;
    std::printf("[ measured ] noise %.0f %%, B = %.3f A: %s in %.1f %%, %.1f pairs\n", 100 * row.spread,
                row.factor, std::string(name(row.outcome)).c_str(), 100 * share, tally.pairs / 2000);
    EXPECT_GE(share, row.at_least) << row.factor;
    if (row.factor != 1) {
      EXPECT_EQ(tally.count[Outcome::same], 0) << row.factor;
    }
  }
}

TEST(PairedRule, IsIncremental) {
  std::mt19937_64 random(37);
  for (const double factor : {1.0, 1.03, 1.06, 1.2}) {
    const std::vector<double> d = interleaved(noises()[2], 50, factor, random);
    PairedResult before;
    for (std::size_t n = 0; n <= d.size(); ++n) {
      const PairedResult now = decide(std::span(d).first(n));
      if (before.outcome != Outcome::more) {
        EXPECT_EQ(now.outcome, before.outcome) << n;  // a decision stays, whatever follows
        EXPECT_EQ(now.pairs, before.pairs) << n;
        EXPECT_EQ(now.next, 0) << n;
      } else if (static_cast<int>(n) < before.next) {
        EXPECT_EQ(now.outcome, Outcome::more) << n;  // between looks there is none
        EXPECT_EQ(now.next, before.next) << n;
      }
      EXPECT_EQ(now.outcome == Outcome::regressed, now.p_regressed <= 0.01) << n;
      EXPECT_EQ(now.outcome == Outcome::improved, now.p_improved <= 0.01) << n;
      before = now;
    }
    EXPECT_NE(before.outcome, Outcome::more) << factor;
  }
}

TEST(PairedRule, WorkedByHand) {
  // Ten of ten above ln 1.02: p = 2^-10 at the first look, of which alpha has a tenth.
  std::vector<double> d = {.051, .032, .064, .023, .045, .037, .058, .026, .071, .042};
  PairedResult result = decide(d);
  EXPECT_EQ(result.outcome, Outcome::regressed);
  EXPECT_EQ(result.pairs, 10);
  EXPECT_DOUBLE_EQ(result.p_regressed, 10 * std::ldexp(1, -10));
  EXPECT_EQ(result.interval.low, .023);
  EXPECT_EQ(result.interval.high, .071);
  EXPECT_DOUBLE_EQ(result.confidence, 0.998);
  // One below, and it wants six more pairs.
  d[3] = 0.019;
  result = decide(d);
  EXPECT_EQ(result.outcome, Outcome::more);
  EXPECT_EQ(result.next, 16);
  // All within 2 %, either side.
  for (std::size_t i = 0; i < d.size(); ++i)
    d[i] = (i % 2 == 0 ? 1 : -1) * (0.001 + 0.0017 * static_cast<double>(i));
  result = decide(d);
  EXPECT_EQ(result.outcome, Outcome::same);
  // With a wider threshold the same numbers as at first are no difference.
  EXPECT_EQ(
      decide(std::vector<double>{.05, .03, .06, .02, .04, .03, .05, .02, .07, .04}, {.tau = 0.08}).outcome,
      Outcome::same);
  // Nothing yet.
  result = decide({});
  EXPECT_EQ(result.outcome, Outcome::more);
  EXPECT_EQ(result.next, 10);
  EXPECT_EQ(result.pairs, 0);
  EXPECT_TRUE(std::isnan(result.estimate));
  std::vector<double> eleven(11, 0.1);
  eleven[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(decide(eleven), std::invalid_argument);
}

}  // namespace
}  // namespace cylon::statistics
