// How chance shares the energy of a gas, against draws from the ensemble and against laws by hand.
#include "harness/core/equipartition.h"
#include "harness/core/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace cylon::core;

// `count` balls of different masses and a locked one, in a slanting tetrahedron.
Scene gas(int count) {
  Scene scene;
  for (int i = 0; i <= count; ++i) {
    Body ball;
    ball.name = "ball" + std::to_string(i);
    ball.mass = 0.5 + i % 5;
    ball.shape = Sphere{0.1};
    ball.collide = true;
    ball.locked = i == count;
    scene.bodies.push_back(ball);
  }
  for (const Vector3& n :
       {Vector3(1, 0.1, 0), Vector3(-1, 1, 0.2), Vector3(-0.2, -1, 1), Vector3(0, -0.3, -1)})
    scene.planes.push_back({"", n.normalized(), -10});
  scene.materials = {{{"*", "*"}, 1, 0}};
  scene.forces = {UniformGravity{{0, -3, 0}}};
  return scene;
}

// A state of the microcanonical ensemble: m v^2 of each axis has the same law.
State drawn(const Scene& scene, std::mt19937_64& random) {
  State state = initial_state(scene);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const double width = 1 / std::sqrt(scene.bodies[i].mass);
    state[i].velocity = width * Vector3(normal(random), normal(random), normal(random));
    state[i].angular_velocity = {7, 0, 0};  // smooth balls do not share it
  }
  return state;
}

const Observable all{.quantity = Quantity::energy_share};
Observable of(std::optional<int> body, Component component) {
  return {.quantity = Quantity::energy_share, .body = body, .component = component};
}

// The part of draws that are out of the bound is the level, within five standard deviations of its count.
TEST(Equipartition, LevelIsThePartOfRightEnginesThatFail) {
  constexpr int draws = 20000, bodies = 12;
  const Scene scene = gas(bodies);
  for (const Observable& q : {of({}, Component::x), of({}, Component::z), of({}, Component::horizontal),
                              of(3, Component::all), of(4, Component::y), of(0, Component::horizontal)})
    for (const double level : {0.3, 0.05, 0.004}) {
      std::mt19937_64 random(17);
      const double allowed = allowed_share(q, scene, level);
      int out = 0;
      for (int i = 0; i < draws; ++i)
        out += std::abs(energy_share(q, scene, drawn(scene, random)) - expected_share(q, scene)) > allowed;
      EXPECT_NEAR(out, level * draws, 5 * std::sqrt(level * draws)) << level;
      EXPECT_NEAR(chance_of_share(q, scene, allowed), level, 1e-9 * level);
    }
}

// The bound on D is safe at any size, and not by far.
TEST(Equipartition, DistributionOfTheSharesFailsNoOftenerThanItsLevel) {
  for (const int bodies : {3, 12, 80})
    for (const double level : {0.3, 0.05}) {
      const Scene scene = gas(bodies);
      const double allowed = allowed_share(all, scene, level);
      EXPECT_NEAR(allowed, std::sqrt(std::log(2 / level) / (2 * bodies)), 1e-12);
      std::mt19937_64 random(5);
      int out = 0, near = 0;
      for (int i = 0; i < 4000; ++i) {
        const double d = energy_share(all, scene, drawn(scene, random));
        out += d > allowed, near += d > allowed / 2;
      }
      EXPECT_LE(out, level * 4000);
      EXPECT_GT(near, 4000 * level) << bodies;
    }
}

// Two balls: n = 6.  An axis has Beta(1, 2): P(share < s) = 1 - (1 - s)^2; a ball Beta(3/2, 3/2) about 1/2.
TEST(Equipartition, TwoBallsByHand) {
  const Scene scene = gas(2);
  const Observable x = of({}, Component::x), ball = of(1, Component::all);
  EXPECT_DOUBLE_EQ(expected_share(x, scene), 1.0 / 3);
  EXPECT_NEAR(chance_of_share(x, scene, 0.2),
              1 - std::pow(1 - (1.0 / 3 - 0.2), 2) + std::pow(2.0 / 3 - 0.2, 2), 1e-14);
  EXPECT_NEAR(chance_of_share(x, scene, 0.5), std::pow(1.0 / 6, 2), 1e-14);
  EXPECT_DOUBLE_EQ(expected_share(ball, scene), 0.5);
  // P(|s - 1/2| > d) = 1 - (2/pi) (asin u + u sqrt(1 - u^2)), u = 2 d
  const double u = 0.6;
  EXPECT_NEAR(chance_of_share(ball, scene, u / 2),
              1 - 2 / std::acos(-1) * (std::asin(u) + u * std::sqrt(1 - u * u)), 1e-13);
  State state = initial_state(scene);
  state[0].velocity = {3, 0, 4}, state[1].velocity = {0, 2, 0};  // m = 0.5, 1.5: 12.5 and 6
  EXPECT_DOUBLE_EQ(energy_share(x, scene, state), 4.5 / 18.5);
  EXPECT_DOUBLE_EQ(energy_share(ball, scene, state), 6 / 18.5);
  EXPECT_DOUBLE_EQ(energy_share(of(0, Component::z), scene, state), 8 / 18.5);
}

TEST(Equipartition, GasesThatChanceWouldNotMakeFail) {
  const Scene scene = gas(80);
  std::mt19937_64 random(3);
  const auto beyond = [&](const Observable& q, const State& state) {
    return std::abs(energy_share(q, scene, state) - expected_share(q, scene)) > allowed_share(q, scene, 1e-4);
  };
  State cold = drawn(scene, random), even = cold, along = cold, still = initial_state(scene);
  EXPECT_FALSE(beyond(all, cold)) << "negative control";
  for (std::size_t i = 0; i < 80; ++i) {
    if (i % 2 == 0) cold[i].velocity *= 0.1;
    even[i].velocity *= 1 / std::sqrt(scene.bodies[i].mass) / even[i].velocity.norm();
    along[i].velocity.x() *= 2;
  }
  EXPECT_TRUE(beyond(all, cold));
  EXPECT_TRUE(beyond(all, even));
  EXPECT_TRUE(beyond(of({}, Component::x), along));
  EXPECT_TRUE(beyond(all, still));
  EXPECT_TRUE(beyond(of({}, Component::x), still));
  along[7].velocity.y() = std::nan("");
  EXPECT_TRUE(std::isnan(energy_share(all, scene, along)));
}

TEST(Equipartition, SaysNothingOfOtherScenes) {
  ASSERT_EQ(energy_share_undefined(all, gas(3)), std::nullopt);
  const std::vector<std::pair<std::string, std::function<void(Scene&)>>> others = {
      {"no sphere",
       [](Scene& s) {
         s.bodies[1].shape = Box{{1, 1, 1}};
       }},
      {"no sphere", [](Scene& s) { s.bodies[1].collide = false; }},
      {"two bodies", [](Scene& s) { s.bodies[0].locked = s.bodies[1].locked = true; }},
      {"not elastic",
       [](Scene& s) {
         s.materials.push_back({{"ball1", "*"}, 0.9, 0});
       }},
      {"not elastic", [](Scene& s) { s.materials[0].friction = 0.1; }},
      {"other forces", [](Scene& s) { s.forces.push_back(Drag{}); }},
      {"joints", [](Scene& s) { s.joints.resize(1); }},
      {"turns",
       [](Scene& s) {
         s.frame = Frame{{0, 0, 0}, {0, 1, 0}};
       }},
      {"a way out", [](Scene& s) { s.planes.pop_back(); }},
      {"a way out", [](Scene& s) { s.planes.clear(); }},
      // a tube, a slab, and a box without a lid
      {"a way out",
       [](Scene& s) {
         s.planes = {{"", {1, 0, 0}, 0}, {"", {-0.6, 0.8, 0}, 0}, {"", {-0.6, -0.8, 0}, 0}};
       }},
      {"a way out",
       [](Scene& s) {
         s.planes = {{"", {1, 0, 0}, -1}, {"", {-1, 0, 0}, -1}};
       }},
      {"a way out", [](Scene& s) {
         s.planes.clear();
         for (const Vector3& n :
              {Vector3(1, 0, 0), Vector3(-1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3(0, 0, -1)})
           s.planes.push_back({"", n, -1});
       }}};
  for (const auto& [why, change] : others) {
    Scene scene = gas(3);
    change(scene);
    const auto said = energy_share_undefined(all, scene);
    ASSERT_TRUE(said) << why;
    EXPECT_NE(said->find(why), std::string::npos) << *said;
  }
  EXPECT_NE(energy_share_undefined(of(3, Component::all), gas(3)), std::nullopt) << "the locked one";
}

// What a verdict is made of: beyond the bound is a failure and no matter of ten times.
TEST(Equipartition, ClaimOfChanceFailsBeyondItsBound) {
  const Scene scene = gas(400);
  Claim claim{
      .label = "energy_share as expected", .observable = of({}, Component::x), .reduction = Reduction::end};
  claim.tolerance.level = 1e-6;
  std::mt19937_64 random(11);
  Recording run;
  run.dt = 0.1, run.steps = {0, 10}, run.states = {initial_state(scene), drawn(scene, random)};
  const Measured right = measure(claim, scene, std::span(&run, 1), 1);
  EXPECT_FALSE(right.broken);
  EXPECT_NEAR(right.allowed, allowed_share(claim.observable, scene, 1e-6), 1e-15);
  EXPECT_LT(right.value, right.allowed);
  for (BodyState& s : run.states[1]) s.velocity.x() *= 2;
  const Measured wrong = measure(claim, scene, std::span(&run, 1), 1);
  EXPECT_TRUE(wrong.broken);
  EXPECT_LT(wrong.value, 10 * wrong.allowed);
  EXPECT_NE(wrong.detail.find("expected 0.3333; chance alone"), std::string::npos) << wrong.detail;
}

}  // namespace
