// What Siconos has is what the scene says, and what a run prints as its own values are its own values.
#include "reference/simulators/siconos/siconos_scene.h"
#include "reference/simulators/siconos/siconos_settings.h"
#include "tests/reference/exact/random_scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace cylon::simulators {
namespace {

using core::Vector3;

constexpr double unit = 0x1p-53;

core::Scene bodies(unsigned seed) {
  exact::RandomScenes random(seed);
  core::Scene scene;
  for (int i = 0; i < 4; ++i) {
    scene.bodies.push_back(
        random.body({random.between(0.3, 0.5), random.between(0.5, 0.7), random.between(0.7, 0.8)}));
    scene.bodies.back().name = fmt::format("body{}", i);
  }
  scene.bodies[1].locked = true;
  return scene;
}

TEST(SiconosWorld, HasMassesInertiaAndMotionsOfTheScene) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const core::Scene scene = bodies(seed);
    const SiconosScene translated = siconos_scene(scene);
    const siconos_border::World world(translated.bodies, translated.contacts, {});
    EXPECT_EQ(translated.index, (std::vector<int>{0, -1, 1, 2}));
    for (const std::size_t i : {0u, 2u, 3u}) {
      const core::Body& body = scene.bodies[i];
      const auto index = static_cast<std::size_t>(translated.index[i]);
      EXPECT_EQ(world.mass(index), body.mass);
      const auto inertia = world.inertia(index);
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
          EXPECT_EQ(inertia[static_cast<std::size_t>(3 * r + c)], body.inertia(r, c));
      const siconos_border::Motion has = world.motion(index);
      const auto& q = has.orientation;
      const core::BodyState& start = body.initial;
      EXPECT_EQ(from_siconos(has.position), start.position);
      EXPECT_EQ(from_siconos(has.velocity), start.velocity);
      EXPECT_LE(core::Quaternion(q[0], q[1], q[2], q[3]).angularDistance(start.orientation), 64 * unit);
      EXPECT_LE((start.orientation * from_siconos(has.spin) - start.angular_velocity).norm(), 64 * unit * 5);
    }
  }
}

// A sphere over a plane, one on a locked sphere, two that move: the first body of each pair moves.
TEST(SiconosScene, HasAContactForEachPairThatMayTouch) {
  core::Scene scene = bodies(11);
  for (core::Body& body : scene.bodies) body.shape = core::Sphere{0.1 + body.mass}, body.collide = true;
  scene.planes = {{"floor", Vector3(0.6, 0.8, 0), -3, {}, {}}};
  scene.materials = {{{"*", "*"}, 0.3, 0.2}, {{"body1", "*"}, 0.7, 0}};
  const SiconosScene all = siconos_scene(scene);
  ASSERT_EQ(all.contacts.size(), 9u);  // 6 pairs of bodies and 3 of bodies that move with the plane
  int planes = 0, still = 0, moving = 0;
  for (std::size_t k = 0; k < all.contacts.size(); ++k) {
    const siconos_border::Contact& contact = all.contacts[k];
    const core::Pair& pair = all.pairs[k];
    const core::Body& body = scene.bodies[static_cast<std::size_t>(pair.body)];
    EXPECT_FALSE(body.locked);
    EXPECT_EQ(contact.radius, 0.1 + body.mass);
    const core::Material material = *core::material_of(scene, pair);
    EXPECT_EQ(contact.restitution, material.restitution);
    EXPECT_EQ(contact.friction, material.friction);
    planes += contact.partner == siconos_border::Partner::plane;
    still += contact.partner == siconos_border::Partner::still_sphere;
    moving += contact.partner == siconos_border::Partner::moving_sphere;
  }
  EXPECT_EQ(planes, 3);
  EXPECT_EQ(still, 3);
  EXPECT_EQ(moving, 3);
}

TEST(SiconosWorld, OptionsHaveSiconossOwnValues) {
  const applied::Settings shipped =
      siconos_settings(siconos_engine("4"), {.dt = 1e-3, .path = "as-shipped"}, {true, true});
  EXPECT_TRUE(shipped.reasons.empty());
  const siconos_border::Settings ours = siconos_border_settings(shipped, 1e-3);
  const siconos_border::Settings own = siconos_border::World::defaults();
  EXPECT_EQ(ours.theta, own.theta);
  EXPECT_EQ(ours.newton_tolerance, own.newton_tolerance);
  EXPECT_EQ(ours.newton_iterations, own.newton_iterations);
  EXPECT_EQ(ours.solver, own.solver);
  EXPECT_FALSE(ours.solver_tolerance || ours.solver_iterations);
  EXPECT_EQ(shipped.at("solver-tolerance"), own.solver_tolerance);
  EXPECT_EQ(shipped.at("solver-iterations"), own.solver_iterations);
}

}  // namespace
}  // namespace cylon::simulators
