// What the rules of as-expert paths see of a scene.
#include "harness/core/scene_kind.h"

#include <gtest/gtest.h>

namespace cylon::core {
namespace {

Body ball(const char* name, double mass) {
  Body body;
  body.name = name, body.mass = mass, body.collide = true;
  body.shape = Sphere{0.3};
  return body;
}

// Two balls over a floor; only the second bounces, and off the floor alone.
Scene court() {
  Scene scene;
  scene.bodies = {ball("a", 2), ball("b", 0.5)};
  scene.planes = {{"floor", Vector3::UnitY(), -1}};
  scene.materials = {{{"*", "*"}, 0, 0.3}, {{"b", "floor"}, 0.7, 0.3}};
  scene.forces = {UniformGravity{{0, -9.81, 0}}};
  return scene;
}

TEST(SceneKind, SeesWhatMayTouchBounceAndPile) {
  const SceneKind kind = scene_kind(court());
  EXPECT_TRUE(kind.touches && kind.bounces && kind.piles);
  EXPECT_FALSE(kind.applied);
  EXPECT_EQ(kind.mass_ratio, 4);
  EXPECT_FALSE(kind.wide());
}

TEST(SceneKind, BouncesOnlyWhereAPairThatMayTouchDoes) {
  Scene scene = court();
  scene.bodies[1].collide = false;
  EXPECT_FALSE(scene_kind(scene).bounces);
  EXPECT_FALSE(scene_kind(scene).piles);
  EXPECT_TRUE(scene_kind(scene).touches);
  scene = court();
  scene.bodies[1].locked = true;  // a locked body and a plane never touch
  EXPECT_FALSE(scene_kind(scene).bounces);
  EXPECT_FALSE(scene_kind(scene).piles) << "a ball on what cannot move";
  EXPECT_EQ(scene_kind(scene).mass_ratio, 1) << "of what moves";
}

TEST(SceneKind, SeesOtherForcesAndWideMasses) {
  Scene scene = court();
  scene.bodies[0].mass = 500;
  scene.forces.emplace_back(Drag{0, 1, 0, 0});
  EXPECT_TRUE(scene_kind(scene).applied);
  EXPECT_TRUE(scene_kind(scene).wide());
  scene = court();
  scene.frame = Frame{{0.7, -0.4, 1.1}, Vector3::Zero()};
  EXPECT_FALSE(scene_kind(scene).applied) << "a frame that only moves has no forces";
  scene.frame->angular_velocity.z() = 0.3;
  EXPECT_TRUE(scene_kind(scene).applied);
}

}  // namespace
}  // namespace cylon::core
