// Scales are ranges of the motion, wherever the origin is.
#include "harness/core/scale.h"

#include <gtest/gtest.h>

#include <cmath>
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

TEST(Scale, NeedsTheTruthThatIsFollowed) {
  Claim claim = claim_of(Quantity::position);
  claim.follows = "fall";
  EXPECT_THROW(scale(claim, thrown({0, 0, 0}, {0, 0, 0}), T), std::logic_error);
}

}  // namespace
