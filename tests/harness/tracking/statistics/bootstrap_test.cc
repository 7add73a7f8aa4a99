#include "harness/tracking/statistics/bootstrap.h"
#include "harness/tracking/statistics/proportion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace cylon::statistics {
namespace {

TEST(Bootstrap, MedianAndMean) {
  const double odd[] = {5, 1, 4}, even[] = {8, 1, 2, 6};
  EXPECT_EQ(median(odd), 4);
  EXPECT_EQ(median(even), 4);
  EXPECT_EQ(mean(even), 4.25);
  EXPECT_TRUE(std::isnan(median({})) && std::isnan(mean({})));
}

struct Level {
  const char* name;
  std::size_t size;
  double (*estimate)(std::span<const double>);
  bool skew;  // lognormal in place of normal
  double truth;
};

class BootstrapLevel : public testing::TestWithParam<Level> {};

// Of 1000 samples the interval holds the truth in 95 % or more, but for three standard errors of that count and the two percent that
// a sample of 40 of a skew distribution is short of the limit.  Intervals of six values are wide: they may hold it more often.
TEST_P(BootstrapLevel, IsWhatItSays) {
  const Level& level = GetParam();
  std::mt19937_64 bits(4);
  std::normal_distribution<double> normal(0, 1);
  int held = 0;
  for (int i = 0; i < 1000; ++i) {
    std::vector<double> sample(level.size);
    for (double& x : sample) x = level.skew ? std::exp(normal(bits)) : 1 + normal(bits);
    const Interval found = bootstrap(sample, level.estimate, 0.025, static_cast<std::uint64_t>(i), 400);
    held += found.low <= level.truth && level.truth <= found.high;
  }
  EXPECT_GE(held, 930 - 21);
  if (level.size >= 40) {
    EXPECT_LE(held, 950 + 21);
  }
}

INSTANTIATE_TEST_SUITE_P(Bootstrap, BootstrapLevel,
                         testing::Values(Level{"MedianOf40", 40, median, true, 1},
                                         Level{"MedianOf6", 6, median, true, 1},
                                         Level{"MedianOf10", 10, median, true, 1},
                                         Level{"MeanOf6", 6, mean, false, 1},
                                         Level{"MeanOf10", 10, mean, false, 1}),
                         [](const auto& level) { return std::string(level.param.name); });

// Two values lie on one side of the median in half of all samples, five in a sixteenth.
TEST(Bootstrap, SaysNothingOfFewerThanSixValues) {
  const double six[] = {1, 2, 3, 4, 5, 6};
  for (std::size_t n = 0; n < 6; ++n)
    EXPECT_TRUE(std::isinf(bootstrap(std::span(six, n), median, 0.025, 7).low)) << n;
  EXPECT_TRUE(std::isfinite(bootstrap(six, median, 0.025, 7).low));
}

TEST(Bootstrap, IsTheSameForTheSameSeedAndUnboundedForOneValue) {
  const double sample[] = {1.5, 2.2, 3.1, 5.9, 8.4, 13.7, 17.3, 19.6, 23.8, 29.1, 31.2}, one[] = {1};
  const Interval a = bootstrap(sample, mean, 0.025, 7), b = bootstrap(sample, mean, 0.025, 7),
                 c = bootstrap(sample, mean, 0.025, 8);
  EXPECT_EQ(a.low, b.low);
  EXPECT_EQ(a.high, b.high);
  EXPECT_TRUE(a.low != c.low || a.high != c.high);
  EXPECT_TRUE(std::isinf(bootstrap(one, mean, 0.025, 7).low));
  EXPECT_THROW(bootstrap(sample, mean, 0.6, 7), std::invalid_argument);
  EXPECT_THROW(bootstrap(sample, mean, 0.025, 7, 10), std::invalid_argument);
}

// Clopper and Pearson's own example is graphical; these are of the definition: 0 of n gives high = 1 - tail^(1/n).
TEST(Proportion, OfTheDefinition) {
  EXPECT_NEAR(proportion_interval(0, 10, 0.025).high, 1 - std::pow(0.025, 0.1), 1e-12);
  EXPECT_NEAR(proportion_interval(10, 10, 0.025).low, std::pow(0.025, 0.1), 1e-12);
  EXPECT_EQ(proportion_interval(0, 10, 0.025).low, 0);
  EXPECT_EQ(proportion_interval(10, 10, 0.025).high, 1);
  EXPECT_EQ(proportion_interval(0, 0, 0.025).high, 1);
  EXPECT_THROW(proportion_interval(3, 2, 0.025), std::invalid_argument);
}

// Each bound is where the sum of the binomial tail is what it says, summed term by term.
TEST(Proportion, TailsAreWhatTheySay) {
  const auto at_least = [](int k, int n, double p) {
    double sum = 0;
    for (int i = k; i <= n; ++i)
      sum += std::exp(std::lgamma(n + 1) - std::lgamma(i + 1) - std::lgamma(n - i + 1) + i * std::log(p) +
                      (n - i) * std::log1p(-p));
    return sum;
  };
  for (const int k : {1, 7, 19, 24}) {
    const Interval found = proportion_interval(static_cast<std::size_t>(k), 25, 0.025);
    EXPECT_NEAR(at_least(k, 25, found.low), 0.025, 1e-10);
    EXPECT_NEAR(1 - at_least(k + 1, 25, found.high), 0.025, 1e-10);
  }
}

// All or nothing; spread; and nearly all the same with a few that are low, where intervals from the sample's own spread hold 0.95 in 77
// of 100 samples.
TEST(Shares, HoldTheirLevel) {
  EXPECT_EQ(share_interval(std::vector<double>(20, 1.0), 0.025).low, proportion_interval(20, 20, 0.025).low);
  EXPECT_EQ(share_interval(std::vector<double>{1, 0, 0.5, 0.5}, 0.025).high,
            proportion_interval(2, 4, 0.025).high);
  EXPECT_EQ(share_interval({}, 0.025).high, 1);
  EXPECT_THROW(share_interval(std::vector<double>{0.5, 1.1}, 0.025), std::invalid_argument);
  std::mt19937_64 bits(3);
  const auto unit = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  const std::function<double()> kinds[] = {[&] { return static_cast<double>(unit() < 0.95); },
                                           [&] { return std::pow(unit(), 1.0 / 19); },
                                           [&] { return unit() < 0.95 ? 0.98 : 0.38; }};
  for (const auto& share : kinds) {
    int held = 0;
    for (int i = 0; i < 1000; ++i) {
      std::vector<double> shares(30);
      for (double& s : shares) s = share();
      const Interval found = share_interval(shares, 0.025);
      held += found.low <= 0.95 && 0.95 <= found.high;
    }
    EXPECT_GE(held, 950 - 21) << &share - kinds;
  }
}

TEST(SignTest, CountsCoins) {
  EXPECT_EQ(sign_test(0, 0), 1);
  EXPECT_EQ(sign_test(3, 3), 1);
  EXPECT_NEAR(sign_test(0, 6), 2.0 / 64, 1e-15);
  EXPECT_NEAR(sign_test(9, 1), 2 * 11.0 / 1024, 1e-15);
  EXPECT_EQ(sign_test(2, 8), sign_test(8, 2));
}

}  // namespace
}  // namespace cylon::statistics
