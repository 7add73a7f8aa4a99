// What Simbody has is what the scene says: masses, inertia, places, speeds and freedoms, read from its own system.
#include "reference/simulators/simbody/simbody_world.h"
#include "tests/reference/exact/random_scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace cylon::simulators {
namespace {

using core::Scene;
using core::Vector3;
using Type = core::JointType;

constexpr double unit = 0x1p-53;
const Vector3 place(0.2, 0.4, -0.1);

Scene bodies(unsigned seed, int count) {
  exact::RandomScenes random(seed);
  Scene scene;
  for (int i = 0; i < count; ++i) {
    scene.bodies.push_back(
        random.body({random.between(0.3, 0.5), random.between(0.5, 0.7), random.between(0.7, 0.8)}));
    scene.bodies.back().name = fmt::format("body{}", i);
  }
  return scene;
}

core::Joint joint(Type type, int body, int to, const Vector3& point) {
  return {type, body, to, point, Vector3(1, -2, 3).normalized(), 0};
}
core::Joint rod(int body, int to) { return {Type::distance, body, to, place, Vector3::UnitY(), 0.7}; }

struct Started {
  std::unique_ptr<SimbodyWorld> world;
  SimTK::State state;
};

Started started(const Scene& scene) {
  const applied::Forest forest = applied::forest_of(scene);
  Started result{std::make_unique<SimbodyWorld>(scene, forest, SimbodyLaw()), {}};
  result.state = result.world->start(scene, forest);
  result.world->system().realize(result.state, SimTK::Stage::Acceleration);
  return result;
}

TEST(SimbodyWorld, HasMassesInertiaAndPlacesOfTheScene) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    Scene scene = bodies(seed, 5);
    scene.bodies[4].locked = true;
    if (seed > 2)
      scene.joints = {joint(Type::ball, 0, core::world, {0.3, 0.1, -0.2}),
                      joint(Type::hinge, 1, 0, {0.5, 0.7, 0.2}), joint(Type::fixed, 2, 1, {0.1, -0.7, 0.3}),
                      joint(Type::ball, 3, 4, {0.1, 0.9, 0.3})};
    const Started run = started(scene);
    for (std::size_t i = 0; i < 4; ++i) {
      const core::Body& body = scene.bodies[i];
      const SimTK::MobilizedBody& has = run.world->mobilized(i);
      const SimTK::MassProperties& mass = has.getBodyMassProperties(run.state);
      EXPECT_EQ(mass.getMass(), body.mass);
      EXPECT_EQ(from_simbody(mass.getMassCenter()), Vector3::Zero());
      const SimTK::Mat33 inertia = mass.getInertia().toMat33();
      const SimTK::Transform& pose = has.getBodyTransform(run.state);
      const core::Matrix3 turn = body.initial.orientation.toRotationMatrix();
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
          EXPECT_NEAR(inertia(r, c), body.inertia(r, c), 16 * unit * body.inertia.norm());
          EXPECT_NEAR(pose.R().asMat33()(r, c), turn(r, c), 64 * unit) << seed;
        }
      EXPECT_LE((from_simbody(pose.p()) - body.initial.position).norm(), 64 * unit * 5) << seed;
    }
    EXPECT_TRUE(run.world->mobilized(4).isGround());
  }
}

struct Mechanism {
  const char* name;
  int bodies;
  std::vector<core::Joint> joints;
  int freedoms, equations;
};

TEST(SimbodyWorld, HasTheFreedomsThatJointsLeave) {
  const Mechanism mechanisms[] = {
      {"free", 2, {}, 12, 0},
      {"ball to the world", 1, {joint(Type::ball, 0, core::world, place)}, 3, 0},
      {"hinge to the world", 1, {joint(Type::hinge, 0, core::world, place)}, 1, 0},
      {"fixed to the world", 1, {joint(Type::fixed, 0, core::world, place)}, 0, 0},
      {"afloat", 2, {joint(Type::hinge, 1, 0, place)}, 7, 0},
      {"distance to the world", 1, {rod(0, core::world)}, 6, 1},
      {"distance of two", 2, {rod(0, 1)}, 12, 1},
      {"ring of balls",
       3,
       {joint(Type::ball, 0, 1, place), joint(Type::ball, 1, 2, place), joint(Type::ball, 2, 0, place)},
       12,
       3},
      {"two hinges",
       1,
       {joint(Type::hinge, 0, core::world, place), joint(Type::hinge, 0, core::world, place)},
       1,
       5},
      {"held twice",
       1,
       {joint(Type::ball, 0, core::world, place), joint(Type::fixed, 0, core::world, place)},
       3,
       6},
  };
  for (const Mechanism& row : mechanisms) {
    Scene scene = bodies(51, row.bodies);
    for (core::Body& body : scene.bodies) body.initial.angular_velocity.setZero();
    scene.joints = row.joints;
    const Started run = started(scene);
    // Free and Ball have a quaternion, whose norm is an equation too.
    int quaternions = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
      quaternions += run.world->mobilized(i).getNumQ(run.state) > run.world->mobilized(i).getNumU(run.state);
    EXPECT_EQ(run.state.getNU(), row.freedoms) << row.name;
    EXPECT_EQ(run.state.getNQErr() - quaternions, row.equations) << row.name;
    // A joint is met where the scene starts; a distance is off by what the scene states.
    if (row.joints.empty() || row.joints[0].type == Type::distance) continue;
    EXPECT_LE(run.state.getQErr().normInf(), 64 * unit) << row.name;
  }
}

TEST(SimbodyWorld, TakesAnotherMassAndTheSameState) {
  const Scene scene = bodies(61, 2);
  Started run = started(scene);
  run.world->set_mass(1, 7.5);
  const SimTK::State later = run.world->moved(run.state);
  run.world->system().realize(later, SimTK::Stage::Velocity);
  EXPECT_EQ(run.world->mobilized(1).getBodyMassProperties(later).getMass(), 7.5);
  EXPECT_EQ(run.world->mobilized(0).getBodyMassProperties(later).getMass(), scene.bodies[0].mass);
  EXPECT_EQ((later.getQ() - run.state.getQ()).normInf(), 0);
  EXPECT_EQ((later.getU() - run.state.getU()).normInf(), 0);
}

}  // namespace
}  // namespace cylon::simulators
