// Scales are ranges of the motion, wherever the origin is.
#include "harness/core/scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <new>
#include <numbers>
#include <stdexcept>

namespace {

using namespace cylon::core;

constexpr double g = 10, T = 2;

// A ball of 3 kg and radius 0.25 m, thrown at `velocity` from `position`.
Scene thrown(const Vector3& position, const Vector3& velocity) {
  Scene scene;
  Body ball;
  ball.mass = 3;
  ball.shape = Sphere{0.25};
  ball.inertia = Matrix3::Identity() * 0.075;
  ball.initial.position = position, ball.initial.velocity = velocity;
  scene.bodies = {ball};
  scene.forces = {UniformGravity{{0, -g, 0}}};
  return scene;
}

Truth fall(const Scene& scene) {
  Truth truth;
  truth.state = [s = initial_state(scene)](double t) {
    State state = s;
    state[0].position += s[0].velocity * t + Vector3(0, -g * t * t / 2, 0);
    state[0].velocity.y() -= g * t;
    return state;
  };
  return truth;
}

Claim claim_of(Quantity quantity) {
  Claim claim;
  claim.observable.quantity = quantity;
  return claim;
}

double followed(Quantity quantity, const Scene& scene) {
  Claim claim = claim_of(quantity);
  claim.follows = "fall", claim.truth = fall(scene);
  return scale(claim, scene, T);
}

double conserved(Quantity quantity, const Scene& scene) {
  Claim claim = claim_of(quantity);
  claim.motion = std::make_shared<RequiredMotion>(fall(scene), T);
  return scale(claim, scene, T);
}

// In the frame of the centre of mass the ball falls from rest: 20 m, 20 m/s, 60 kg m/s, 600 J.
TEST(Scale, IsTheRangeInTheFrameOfTheStart) {
  for (const Vector3& position : {Vector3(0, 0, 0), Vector3(10, 10, 0), Vector3(0, -1e4, 0)})
    for (const Vector3& velocity : {Vector3(0, 0, 0), Vector3(3, 4, 0.5)}) {
      const Scene scene = thrown(position, velocity);
      EXPECT_NEAR(followed(Quantity::position, scene), 20, 1e-9);
      EXPECT_NEAR(followed(Quantity::velocity, scene), 20, 1e-9);
      EXPECT_NEAR(conserved(Quantity::linear_momentum, scene), 60, 1e-9);
      EXPECT_NEAR(conserved(Quantity::energy, scene), 600, 1e-8);
    }
}

TEST(Scale, CountsWhatIsFixed) {
  Scene scene = thrown({0, 0, 0}, {3, 0, 0});
  scene.planes = {{"wall", Vector3::UnitX(), -100}};
  EXPECT_TRUE(anything_fixed(scene));
  EXPECT_NEAR(followed(Quantity::position, scene), std::hypot(6, 20), 1e-9);
  EXPECT_NEAR(conserved(Quantity::energy, scene), 600, 1e-8);  // 13.5 J to 613.5 J
}

TEST(Scale, IsOfSizeAndWeightWhereNothingMoves) {
  Scene scene = thrown({5, 5, 5}, {0, 0, 0});
  scene.planes = {{"floor", Vector3::UnitY(), 4.75}};
  EXPECT_EQ(scale(claim_of(Quantity::position), scene, T), 0.25);
  EXPECT_EQ(scale(claim_of(Quantity::normal_gap), scene, T), 0.5);
  EXPECT_EQ(scale(claim_of(Quantity::energy), scene, T), 3 * g * 0.25);
  EXPECT_EQ(scale(claim_of(Quantity::linear_momentum), scene, T), 3 * g * T);
  EXPECT_EQ(scale(claim_of(Quantity::velocity), scene, T), g * T);
  scene.forces.clear();
  EXPECT_EQ(scale(claim_of(Quantity::velocity), scene, T), 0.25 / T);
}

// A steady spin has no range, but its speed and its momentum have a zero.
TEST(Scale, IsOfTheValueWhereThatDoesNotChange) {
  Scene scene = thrown({5, 5, 5}, {0, 0, 0});
  scene.forces.clear();
  scene.bodies[0].initial.angular_velocity = {0, 4, 0};
  EXPECT_EQ(scale(claim_of(Quantity::angular_velocity), scene, T), 4);
  EXPECT_NEAR(scale(claim_of(Quantity::angular_momentum), scene, T), 0.3, 1e-15);
  EXPECT_NEAR(scale(claim_of(Quantity::energy), scene, T), 0.6, 1e-15);
}

// x = cos(2 pi n t/T) is 1 at every even time of which n is a multiple: no range there.
TEST(Scale, SeesPeriodsThatDivideTheDuration) {
  Scene scene = thrown({1, 0, 0}, {0, 0, 0});
  scene.forces.clear();
  for (const int periods : {1, 16, 64, 255, 256, 512, 1024}) {
    Truth truth;
    truth.state = [s = initial_state(scene), periods](double t) {
      State state = s;
      state[0].position.x() = std::cos(2 * std::numbers::pi * periods * t / T);
      return state;
    };
    Claim claim = claim_of(Quantity::position);
    claim.follows = "cosine", claim.truth = truth;
    EXPECT_NEAR(scale(claim, scene, T), 2, 0.01) << periods;
  }
}

// 1 cm of swing under gravity for 100 s: g T = 1000 m/s is no scale of its momentum.
TEST(Scale, OfASlowMotionIsNotThatOfAFall) {
  Scene scene = thrown({0, 0, 0}, {0, 0, 0});
  constexpr double amplitude = 1e-2, duration = 100;
  Truth truth;
  truth.state = [s = initial_state(scene)](double t) {
    State state = s;
    state[0].position.x() = amplitude * std::sin(t), state[0].velocity.x() = amplitude * std::cos(t);
    return state;
  };
  scene.planes = {{"floor", Vector3::UnitY(), -10}};
  Claim claim = claim_of(Quantity::velocity);
  claim.follows = "swing", claim.truth = truth;
  EXPECT_NEAR(scale(claim, scene, duration), 2 * amplitude, 1e-4);
  claim.observable.quantity = Quantity::linear_momentum;
  EXPECT_NEAR(scale(claim, scene, duration), 3 * 2 * amplitude, 3e-4);
}

// A claim that conserves takes the motion up to its own end: 5 m of the fall in 1 s, not 20 m in 2 s.
TEST(Scale, EndsWithTheClaim) {
  const Scene scene = thrown({0, 0, 0}, {0, 0, 0});
  Claim claim = claim_of(Quantity::energy);
  claim.motion = std::make_shared<RequiredMotion>(fall(scene), T);
  claim.until = 1;
  EXPECT_NEAR(scale(claim, scene, T), 3 * g * 5, 1e-9);
  claim.until = 10;
  EXPECT_NEAR(scale(claim, scene, T), 3 * g * 20, 1e-8);
}

TEST(Scale, NeedsTheTruthThatIsFollowed) {
  Claim claim = claim_of(Quantity::position);
  claim.follows = "fall";
  EXPECT_THROW(scale(claim, thrown({0, 0, 0}, {0, 0, 0}), T), std::logic_error);
}

// A path that could not be made, for lack of memory, stayed empty, and later claims were judged by it.
TEST(Scale, TakesNoMotionThatWasGivenUpHalfWay) {
  const Scene scene = thrown({0, 0, 0}, {1, 2, 3});
  Truth truth = fall(scene);
  int calls = 0;
  truth.state = [whole = truth.state, &calls](double t) {
    if (++calls == 100) throw std::bad_alloc();
    return whole(t);
  };
  const RequiredMotion motion(truth, T);
  EXPECT_THROW(motion.path(1.5), std::bad_alloc);
  EXPECT_EQ(motion.path(1.5).size(), RequiredMotion(fall(scene), T).path(1.5).size());
  EXPECT_GT(motion.path(1.5).size(), 200u);
}

}  // namespace
