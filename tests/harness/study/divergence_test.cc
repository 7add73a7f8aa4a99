// The first difference of two motions: on motions of known distance, and on equal motions.
#include "harness/study/divergence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cylon::study {
namespace {

TEST(CommonMultiple, FindsLeastCommonMultipleIfAny) {
  const struct {
    double a, b;
    std::int64_t of_a, of_b;  // 0: none
  } cases[] = {
      {0.001, 0.001, 1, 1},    {1. / 60, 1. / 240, 1, 4}, {1. / 240, 1. / 60, 4, 1}, {0.001, 1. / 60, 50, 3},
      {0.3, 0.2, 2, 3},        {0.1, 0.7, 7, 1},          {0.001, 9.999, 9999, 1},   {0.001, 10.001, 0, 0},
      {1, std::sqrt(2), 0, 0}, {1, 1 + 1e-12, 1, 1},      {0.001, 0.00100001, 0, 0},
  };
  for (const auto& c : cases) {
    const auto found = common_multiple(c.a, c.b);
    ASSERT_EQ(found.has_value(), c.of_a > 0) << c.a << ' ' << c.b;
    if (!found) continue;
    EXPECT_EQ(found->of_a, c.of_a) << c.a << ' ' << c.b;
    EXPECT_EQ(found->of_b, c.of_b) << c.a << ' ' << c.b;
  }
}

class Divergence : public testing::Test {
 protected:
  Divergence() {
    for (int i = 0; i < 3; ++i) {
      core::Body body;
      body.name = std::string(1, static_cast<char>('a' + i));
      body.mass = 2;
      body.initial.position = {1.5 * i, 0, 0};  // the farthest is 1.5 m from the centre: L
      body.initial.velocity = {0, 0.5, 0};      // V
      body.initial.angular_velocity = {0, 0, 3};
      scene.bodies.push_back(body);
    }
    for (int k = 0; k < 8; ++k) {
      track.time.push_back(0.25 * k);
      core::State state;
      for (const core::Body& body : scene.bodies) {
        state.push_back(body.initial);
        state.back().position += track.time.back() * body.initial.velocity;
      }
      track.states.push_back(state);
    }
    other = track;
  }

  std::vector<Curve> curves(double tolerance) const { return divergence(scene, 2, track, other, tolerance); }
  static const Curve& of(const std::vector<Curve>& all, core::Quantity quantity) {
    for (const Curve& c : all)
      if (c.quantity == quantity) return c;
    throw std::out_of_range("no such curve");
  }

  core::Scene scene;
  core::Trajectory track, other;
};

TEST_F(Divergence, EqualRunsDoNotDiffer) {
  const auto all = curves(0);
  EXPECT_EQ(all.size(), 7u);
  EXPECT_EQ(first_to_part(all), nullptr);
  for (const Curve& c : all) EXPECT_EQ(c.distance, std::vector<double>(8, 0.0));
}

TEST_F(Divergence, FindsSampleBodyAndQuantity) {
  for (std::size_t k = 3; k < 8; ++k) other.states[k][1].position.z() += 0.01 * static_cast<double>(k - 2);
  const auto all = curves(1e-2);  // 0.015 m of L = 1.5 m
  const Curve* first = first_to_part(all);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->quantity, core::Quantity::position);
  EXPECT_EQ(first->first, 4u);
  EXPECT_EQ(first->body[4], 1);
  EXPECT_NEAR(first->distance[4], 0.02, 1e-16);
  EXPECT_EQ(first->largest, 7u);
  EXPECT_DOUBLE_EQ(first->allowed, 0.015);
  EXPECT_FALSE(of(all, core::Quantity::velocity).first);
  EXPECT_EQ(of(curves(0), core::Quantity::position).first, 3u);
}

TEST_F(Divergence, AllowedScalesWithScene) {
  const auto all = curves(0.5);
  const struct {
    core::Quantity quantity;
    double allowed;
  } cases[] = {{core::Quantity::position, 0.75},
               {core::Quantity::orientation, 0.5},
               {core::Quantity::velocity, 0.5 * 4.5},  // 3 rad/s at 1.5 m are faster than 0.5 m/s
               {core::Quantity::angular_velocity, 1.5},
               {core::Quantity::linear_momentum, 0.5 * 6 * 4.5},
               {core::Quantity::angular_momentum, 0.5 * 6 * 4.5 * 1.5},
               {core::Quantity::energy, 0.5 * 6 * 4.5 * 4.5 / 2}};
  for (const auto& c : cases)
    EXPECT_DOUBLE_EQ(of(all, c.quantity).allowed, c.allowed) << core::name(c.quantity);
}

TEST_F(Divergence, QuaternionSignIsIgnored) {
  for (core::State& state : other.states) state[2].orientation.coeffs() *= -1;
  EXPECT_EQ(first_to_part(curves(0)), nullptr);
}

TEST_F(Divergence, ZeroToleranceDetectsOneBit) {
  double& v = other.states[5][2].velocity.y();
  v = std::nextafter(v, 1.0);
  const auto all = curves(0);
  const Curve* first = first_to_part(all);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->first, 5u);
  EXPECT_EQ(of(all, core::Quantity::velocity).body[5], 2);
  EXPECT_EQ(first_to_part(curves(1e-12)), nullptr);
}

TEST_F(Divergence, NaNCountsAsDifference) {
  other.states[6][0].position.x() = std::numeric_limits<double>::quiet_NaN();
  const auto all = curves(1e6);
  const Curve* first = first_to_part(all);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->first, 6u);
  EXPECT_EQ(of(all, core::Quantity::position).largest, 6u);  // larger than any number
}

// Of several that part at one sample, the one that is farthest beyond what is allowed leads.
TEST_F(Divergence, ReportsLargestDifferenceOfSample) {
  other.states[2][0].position.x() += 0.3;          // 0.2 L
  other.states[2][0].angular_velocity.z() += 1.5;  // half of its scale
  const auto all = curves(1e-3);
  const Curve* first = first_to_part(all);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->quantity, core::Quantity::angular_velocity);
}

}  // namespace
}  // namespace cylon::study
