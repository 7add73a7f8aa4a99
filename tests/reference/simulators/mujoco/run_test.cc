// What MuJoCo does silently is seen: a reset is not a state, contacts without room end the run, an error is a death.
#include "harness/core/simulator.h"
#include "reference/simulators/mujoco/mujoco_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace cylon::simulators {
namespace {

using core::Vector3;

// A body on a spring that an explicit step of dt makes unstable beyond dt^2 k = 4 m, beside a locked one.
core::Scene on_a_spring(double stiffness) {
  core::Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].name = "a", scene.bodies[1].name = "wall";
  scene.bodies[0].initial.position = {0.3, -0.1, 0.2};
  scene.bodies[1].locked = true;
  scene.forces = {core::Spring{0, Vector3::Zero(), core::world, Vector3::Zero(), stiffness, 0, 0}};
  return scene;
}

struct End {
  core::State state;
  std::vector<std::string> remarks;
};

End run(const core::Scene& scene, double dt, int steps, const char* integrator = "") {
  const auto simulator = core::make_simulator();
  core::Setup setup;
  setup.dt = dt, setup.integrator = integrator;
  EXPECT_EQ(simulator->unsupported(scene, setup), std::nullopt);
  simulator->load(scene, setup);
  for (int i = 0; i < steps; ++i) simulator->step();
  End end;
  simulator->read(end.state);
  end.remarks = simulator->remarks();
  return end;
}

TEST(MujocoRun, ShowsThatItWasReset) {
  for (const char* integrator : {"euler", "implicit", "rk4"}) {
    const End stable = run(on_a_spring(1e5), 1e-3, 500, integrator);
    EXPECT_TRUE(stable.state[0].position.allFinite()) << integrator;
    EXPECT_TRUE(stable.remarks.empty()) << integrator;
    const End lost = run(on_a_spring(3e7), 1e-3, 500, integrator);
    EXPECT_TRUE(lost.state[0].position.array().isNaN().all()) << integrator;
    EXPECT_TRUE(lost.state[0].orientation.coeffs().array().isNaN().all()) << integrator;
    EXPECT_TRUE(lost.state[1].position.allFinite()) << "a locked body is where it is";
    ASSERT_EQ(lost.remarks.size(), 1U) << integrator;
    EXPECT_NE(lost.remarks[0].find("MuJoCo reset itself to the initial pose in step"), std::string::npos);
  }
}

// After a load nothing of that is left.
TEST(MujocoRun, StartsAnew) {
  const auto simulator = core::make_simulator();
  core::State state;
  for (const double stiffness : {3e7, 1e5}) {
    simulator->load(on_a_spring(stiffness), {.dt = 1e-3});
    for (int i = 0; i < 500; ++i) simulator->step();
    simulator->read(state);
    EXPECT_EQ(state[0].position.allFinite(), stiffness < 1e6);
    EXPECT_EQ(simulator->remarks().empty(), stiffness < 1e6);
  }
}

// What a force says while MuJoCo calls for it reaches the caller, and not MuJoCo.
TEST(MujocoRun, EndsWithTheSentenceOfAForce) {
  core::Scene scene = on_a_spring(10);
  scene.forces.emplace_back(core::Thrust{.body = 0, .mass_rate = -1, .exhaust_velocity = Vector3(0, 1, 0)});
  for (const char* integrator : {"euler", "rk4"}) try {
      run(scene, 0.125, 9, integrator);
      ADD_FAILURE() << "the mass was used up";
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("the mass of 'a' is"), std::string::npos) << error.what();
    }
}

// One body of many balls in the floor has more contacts than there is room for.
TEST(MujocoRun, EndsWhereContactsHaveNoRoom) {
  const auto bed = [](int balls) {
    core::Scene scene = on_a_spring(0);
    core::Compound compound;
    for (int i = 0; i < balls; ++i)
      compound.parts.push_back(
          {core::Sphere{0.1}, 1, Vector3(i % 40, 0, i / 40), Eigen::Quaterniond::Identity()});
    scene.bodies[0].shape = compound, scene.bodies[0].collide = true;
    scene.bodies[0].initial.position.setZero();
    scene.planes = {{"floor", Vector3::UnitY(), -0.099}};
    scene.materials = {{{"*", "*"}, 0, 0}};
    return scene;
  };
  EXPECT_TRUE(run(bed(1500), 1e-3, 1).state[0].position.allFinite());
  try {
    run(bed(1501), 1e-3, 1);
    ADD_FAILURE() << "a contact was dropped";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("no room for more than 1500 contacts"), std::string::npos);
  }
}

TEST(MujocoRunDeathTest, AnErrorIsItsEnd) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_DEATH(
      {
        mujoco_handle_errors();
        mju_error("no such thing");
      },
      "MuJoCo: no such thing");
}

TEST(MujocoRun, SaysWhyAModelIsRefused) {
  try {
    mujoco_compile("<mujoco><nonsense/></mujoco>");
    ADD_FAILURE() << "nonsense was taken";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("MuJoCo refuses the scene: XML Error"), std::string::npos);
  }
}

}  // namespace
}  // namespace cylon::simulators
