// What Simbody does in a run: one step a step, a force's sentence reaches the caller, what it throws is a state that is
// not finite with its words.
#include "harness/core/simulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

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

constexpr const char* fixed_steps[] = {
    "semi-explicit-euler", "semi-explicit-euler-2", "verlet",
    "runge-kutta-3",       "runge-kutta-merson",    "runge-kutta-feldberg"};

// x'' = -k x by one step of Euler:  v' = v - dt k x,  x' = x + dt v'.  Ten steps are ten of these.
TEST(SimbodyRun, TakesOneStepADt) {
  const auto simulator = core::make_simulator();
  const double dt = 0.03, k = 25;
  const core::Scene scene = on_a_spring(k);
  simulator->load(scene, {.dt = dt, .integrator = "semi-explicit-euler"});
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

// Where the step is far too large, numbers overflow: no state is made up, and a locked body is where it is.
TEST(SimbodyRun, ShowsThatItIsLost) {
  for (const char* integrator : fixed_steps) {
    const auto simulator = core::make_simulator();
    simulator->load(on_a_spring(1e12), {.dt = 1, .integrator = integrator});
    for (int i = 0; i < 400; ++i) simulator->step();
    core::State state;
    simulator->read(state);
    EXPECT_FALSE(state[0].position.allFinite() && state[0].position.norm() < 1e100) << integrator;
    EXPECT_TRUE(state[1].position.allFinite()) << integrator;
    simulator->load(on_a_spring(10), {.dt = 1e-3, .integrator = integrator});
    simulator->step();
    simulator->read(state);
    EXPECT_TRUE(state[0].position.allFinite()) << "a load starts anew";
    EXPECT_TRUE(simulator->remarks().empty()) << integrator;
  }
}

TEST(SimbodyRun, EndsWithTheSentenceOfAForce) {
  core::Scene scene = on_a_spring(10);
  scene.forces.emplace_back(core::Thrust{.body = 0, .mass_rate = -1, .exhaust_velocity = Vector3(0, 1, 0)});
  for (const char* integrator : fixed_steps) try {
      const auto simulator = core::make_simulator();
      simulator->load(scene, {.dt = 0.125, .integrator = integrator});
      for (int i = 0; i < 9; ++i) simulator->step();
      ADD_FAILURE() << "the mass was used up";
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("the mass of 'a' is"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace cylon::simulators
