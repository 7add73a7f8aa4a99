// Impact times computed in vector form have the same bits as those computed one by one.
#include "engine/ballistic/crowd.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace cylon::engine::ballistic {
namespace {

Flight flight(std::mt19937& random, const Vector3& gravity) {
  std::uniform_real_distribution<Real> side(-2, 2), size(0, Real(0.4)), age(0, 1);
  Flight f;
  f.position = {side(random), side(random), side(random)};
  f.velocity = {side(random), side(random), side(random)};
  f.acceleration = gravity;
  f.radius = size(random);
  f.since = static_cast<Time>(age(random));
  return f;
}

class Meetings : public testing::TestWithParam<Real> {};

TEST_P(Meetings, VectorizedBitsAgreeWithSinglePairs) {
  std::mt19937 random(7);
  const Vector3 gravity = GetParam() * Vector3(Real(0.3), Real(-9.81), Real(0.7));
  int met = 0, near = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<Flight> flights;
    for (std::size_t i = 0; i < 1 + Crowd::capacity; ++i) flights.push_back(flight(random, gravity));
    Flight& one = flights[0];
    // touching, overlapping, in one place, and points on one line
    flights[1].position = one.position, flights[1].since = one.since;
    flights[1].position.x() += flights[1].radius + one.radius;
    flights[2].position = flights[2].position * Real(0.01) + one.position, flights[2].since = one.since;
    flights[3] = one;
    if (round % 2 == 0) {
      one.radius = flights[4].radius = 0;
      one.since = flights[4].since = 0;
      one.position = {0, 0, 0}, flights[4].position = {1, 0, 0};
      one.velocity = {1, 0, 0}, flights[4].velocity = {-1, 0, 0};
    }
    Crowd crowd;
    for (std::size_t i = 1; i < flights.size(); ++i) crowd.add(i);
    ASSERT_TRUE(crowd.full());
    crowd.meet(one, flights);
    for (std::size_t i = 0; i < crowd.size(); ++i) {
      const Flight& other = flights[crowd.body(i)];
      const bool points = one.radius + other.radius == 0;
      const Time alone = contact(one, other).time, turned = contact(other, one).time;
      EXPECT_EQ(alone, turned);
      near += crowd.near(i), met += std::isfinite(crowd.time(i));
      const Time expected = points ? std::numeric_limits<Time>::infinity() : alone;
      if (points || !crowd.near(i)) {
        EXPECT_EQ(crowd.time(i), expected) << round << ' ' << i;
      }
    }
  }
  // most pass, some meet, some of the prepared ones are near
  EXPECT_GT(met, 100);
  EXPECT_LT(met, 200 * 32);
  EXPECT_GE(near, 200);
}

INSTANTIATE_TEST_SUITE_P(Gravity, Meetings, testing::Values(Real(0), Real(1)));

}  // namespace
}  // namespace cylon::engine::ballistic
