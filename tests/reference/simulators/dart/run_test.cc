// What DART does in a run: one step a step, a force's sentence reaches the caller, contacts as they are told, what its
// solvers leave unsolved, and a body past the edge of the box that stands for a plane.
#include "harness/core/simulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace cylon::simulators {
namespace {

using core::Vector3;

core::Scene on_a_spring(double stiffness) {
  core::Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].name = "a", scene.bodies[1].name = "wall";
  scene.bodies[0].initial.position = {0.3, -0.1, 0.2};
  scene.bodies[1].locked = true;
  scene.forces = {core::Spring{0, Vector3::Zero(), core::world, Vector3::Zero(), stiffness, 0, 0}};
  return scene;
}

// x'' = -k x by one step of Euler:  v' = v - dt k x,  x' = x + dt v'.
TEST(DartRun, TakesOneStepADt) {
  const auto simulator = core::make_simulator();
  const double dt = 0.03, k = 25;
  const core::Scene scene = on_a_spring(k);
  simulator->load(scene, {.dt = dt});
  Vector3 x = scene.bodies[0].initial.position, v = Vector3::Zero();
  core::State state;
  for (int i = 0; i < 1000; ++i) {
    simulator->step();
    v -= dt * k * x, x += dt * v;
  }
  simulator->read(state);
  EXPECT_LE((state[0].position - x).norm(), 1e-12);
  EXPECT_LE((state[0].velocity - v).norm(), 1e-12);
}

TEST(DartRun, EndsWithTheSentenceOfAForce) {
  core::Scene scene = on_a_spring(10);
  scene.forces.emplace_back(core::Thrust{.body = 0, .mass_rate = -1, .exhaust_velocity = Vector3(0, 1, 0)});
  const auto simulator = core::make_simulator();
  simulator->load(scene, {.dt = 0.125});
  try {
    for (int i = 0; i < 9; ++i) simulator->step();
    ADD_FAILURE() << "the mass was used up";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("the mass of 'a' is"), std::string::npos) << error.what();
  }
}

core::Scene on_the_floor(double speed) {
  core::Scene scene;
  scene.bodies.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    core::Body& body = scene.bodies[i];
    body.name = std::string(1, static_cast<char>('a' + i));
    body.shape = core::Box{{0.5, 0.5, 0.5}};
    body.inertia = core::Matrix3::Identity() / 6;
    body.collide = true;
    body.initial.position = {0, 0.5 + static_cast<double>(i), 0};
  }
  scene.bodies[0].initial.velocity = {speed, 0, 0};
  scene.planes = {{"floor", Vector3::UnitY(), 0, {}, {}}};
  scene.materials = {{{"*", "*"}, 0, 0.4}};
  scene.forces = {core::UniformGravity{}};
  return scene;
}

std::string remarks(const core::Scene& scene, std::map<std::string, std::string> options, int steps) {
  const auto simulator = core::make_simulator();
  simulator->load(scene, {.dt = 1. / 60, .options = std::move(options)});
  for (int i = 0; i < steps; ++i) simulator->step();
  std::string all;
  for (const std::string& one : simulator->remarks()) all += one + "\n";
  return all;
}

// One sweep does not solve a stack; as many as it takes do, and so does Dantzig's method.
TEST(DartRun, TellsWhatItLeavesUnsolved) {
  const core::Scene scene = on_the_floor(0);
  const std::string told = remarks(scene, {{"solver", "pgs"}, {"sweeps", "1"}}, 5);
  EXPECT_NE(told.find("DART did not solve 5 systems of contacts and loops in 5 steps, the first in step 1"),
            std::string::npos)
      << told;
  EXPECT_EQ(remarks(scene, {{"solver", "pgs"}, {"sweeps", "100000"}, {"sweep-change", "1e-4"}}, 5), "");
  EXPECT_EQ(remarks(scene, {{"solver", "dantzig-alone"}}, 5), "");
}

// The contacts that are told are all that acts beside gravity: what they give each body in a step is what its momentum
// gains, and no more.  The friction of two bodies is within DART's pyramid.  That of a single point may not be: its bound
// is of the normal forces before friction, which shifts them from one corner to another.
TEST(DartRun, TellsContactsThatMakeTheMotion) {
  core::Scene scene = on_the_floor(2.5);
  scene.bodies[2].shape = core::Sphere{0.5};
  for (std::size_t i = 0; i < 3; ++i) scene.bodies[i].mass = 0.7 + 0.4 * static_cast<double>(i);
  const auto simulator = core::make_simulator();
  const double dt = 1e-3;
  simulator->load(scene, {.dt = dt});
  core::State before, after;
  simulator->read(before);
  double rubbed = 0;
  for (int step = 0; step < 5; ++step) {
    simulator->step();
    simulator->read(after);
    std::vector<Vector3> gained(3, Vector3::Zero()), friction(4, Vector3::Zero());
    std::vector<double> normal(4, 0.0);  // by who is above or below: the floor, -, b, c
    bool floor = false, boxes = false, ball = false;
    for (const core::Contact& contact : simulator->contacts()) {
      const core::Pair& pair = contact.pair;
      const Vector3 impulse = *contact.impulse * contact.normal + *contact.friction;
      gained[static_cast<std::size_t>(pair.body)] += impulse;
      if (pair.plane < 0) gained[static_cast<std::size_t>(pair.other)] -= impulse;
      // The normal is towards the pair's body: up from the floor, and down from what lies on it.
      EXPECT_NEAR(contact.normal.y(), pair.plane >= 0 ? 1 : -1, 1e-9);
      EXPECT_TRUE(pair.plane >= 0 || pair.body < pair.other) << pair.body << pair.other;
      EXPECT_LE(std::abs(contact.friction->dot(contact.normal)), 1e-12);
      normal[static_cast<std::size_t>(pair.other + 1)] += *contact.impulse;
      friction[static_cast<std::size_t>(pair.other + 1)] += *contact.friction;
      floor |= pair.plane == 0 && pair.body == 0;
      boxes |= pair.plane < 0 && pair.body == 0 && pair.other == 1;
      ball |= pair.plane < 0 && pair.body == 1 && pair.other == 2;
    }
    EXPECT_TRUE(floor && boxes && ball) << "step " << step;
    for (const std::size_t i : {0u, 2u, 3u})
      EXPECT_LE(friction[i].norm(), std::sqrt(2) * 0.4 * normal[i] * (1 + 1e-9)) << "step " << step;
    rubbed += friction[0].norm();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 momentum = scene.bodies[i].mass * (after[i].velocity - before[i].velocity);
      const Vector3 weight = scene.bodies[i].mass * dt * core::gravity(scene);
      EXPECT_LE((momentum - weight - gained[i]).norm(), 1e-12) << "body " << i << ", step " << step;
    }
    before = after;
  }
  EXPECT_GT(rubbed, 1e-3);
}

TEST(DartRun, TellsWhoPassedTheEdgeOfAPlane) {
  core::Scene scene = on_the_floor(403);
  scene.bodies.resize(1);
  scene.materials[0].friction = 0;
  EXPECT_EQ(remarks(scene, {}, 140), "");
  EXPECT_EQ(remarks(scene, {}, 180), "'a' passed the edge of the box that stands for 'floor' in step 149\n");
}

}  // namespace
}  // namespace cylon::simulators
