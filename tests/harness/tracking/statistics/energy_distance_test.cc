#include "harness/tracking/statistics/energy_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace cylon::statistics {
namespace {

// The definition, sum by sum.
double energy(const std::vector<double>& x, std::size_t cut) {
  const std::vector<double> a(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(cut));
  const std::vector<double> b(x.begin() + static_cast<std::ptrdiff_t>(cut), x.end());
  const auto mean_distance = [](const std::vector<double>& p, const std::vector<double>& q, bool same) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = same ? i + 1 : 0; j < q.size(); ++j) sum += std::abs(p[i] - q[j]), count += 1;
    return sum / count;
  };
  const auto n = static_cast<double>(a.size()), m = static_cast<double>(b.size());
  return n * m / (n + m) *
         (2 * mean_distance(a, b, false) - mean_distance(a, a, true) - mean_distance(b, b, true));
}

TEST(EnergyDistance, AgreesWithItsDefinition) {
  std::mt19937_64 random(41);
  std::student_t_distribution<double> t(2);
  for (const std::size_t size : {4U, 5U, 17U, 50U}) {
    std::vector<double> x(size);
    for (double& one : x) one = t(random);
    const std::vector<double> q = energy_of_cuts(x);
    ASSERT_EQ(q.size(), size + 1);
    for (std::size_t cut = 0; cut <= size; ++cut) {
      if (cut < 2 || cut + 2 > size) {
        EXPECT_TRUE(std::isinf(q[cut]) && q[cut] < 0) << cut;
      } else {
        EXPECT_NEAR(q[cut], energy(x, cut), 1e-11) << size << ", " << cut;  // 2500 distances of some ten
      }
    }
  }
}

// Worked by hand: of 0 0 | 3 3 the distance between is 3 and within 0, so Q = 4/4 (6 - 0 - 0); of 0 0 3 | 3
// with fewer than two on one side there is none.
TEST(EnergyDistance, WorkedByHand) {
  const double x[] = {0, 0, 3, 3};
  const std::vector<double> q = energy_of_cuts(x);
  EXPECT_DOUBLE_EQ(q[2], 6);
  EXPECT_TRUE(std::isinf(q[1]) && std::isinf(q[3]));
  EXPECT_EQ(energy_of_cuts({}).size(), 1U);
}

// A step is where the statistic is largest; a change of spread alone shows as well, which means would not
// see.
TEST(EnergyDistance, DetectsDifferentSpread) {
  std::mt19937_64 random(43);
  std::normal_distribution<double> normal;
  std::vector<double> x(200);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = (i < 120 ? 1 : 8) * normal(random);
  const std::vector<double> q = energy_of_cuts(x);
  const auto best = std::max_element(q.begin(), q.end()) - q.begin();
  EXPECT_NEAR(static_cast<double>(best), 120, 8);  // the first wide values may look narrow
}

}  // namespace
}  // namespace cylon::statistics
