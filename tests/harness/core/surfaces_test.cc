// Classes of surfaces say what material_of says of every pair, and stay few where names are many.
#include "harness/core/surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace {

using namespace cylon::core;

Body ball(const std::string& name) {
  Body body;
  body.name = name;
  body.shape = Sphere{0.5};
  body.collide = true;
  return body;
}

Material row(const std::string& x, const std::string& y, double e, double mu = 0) {
  Material m;
  m.between[0] = x, m.between[1] = y, m.restitution = e, m.friction = mu;
  return m;
}

void expect_same_as_pair_by_pair(const Scene& scene) {
  const Surfaces classes = surfaces(scene);
  std::optional<Pair> first;
  for (const Pair& pair : touching_pairs(scene)) {
    const int one = classes.of_body[static_cast<std::size_t>(pair.body)];
    const int other = pair.plane >= 0 ? classes.of_plane[static_cast<std::size_t>(pair.plane)]
                                      : classes.of_body[static_cast<std::size_t>(pair.other)];
    const int index = classes.material(one, other);
    EXPECT_EQ(index, classes.material(other, one));
    const auto expected = material_of(scene, pair);
    ASSERT_EQ(index >= 0, expected.has_value());
    if (!expected && !first) first = pair;
    if (!expected) continue;
    const Material& got = scene.materials[static_cast<std::size_t>(index)];
    EXPECT_EQ(got.restitution, expected->restitution);
    EXPECT_EQ(got.friction, expected->friction);
  }
  EXPECT_EQ(pair_without_material(scene), first);
}

// Half of the scenes: groups "x" and "default" in any mixture, masks that may be empty of what there is.
void draw_groups(Scene& scene, std::mt19937& random) {
  if (random() % 2 == 0) return;
  const std::vector<std::vector<std::string>> lists = {{}, {"x"}, {"default"}, {"default", "x"}, {"nobody"}};
  const auto draw = [&](auto& thing) {
    thing.collision_groups = lists[random() % 4], thing.collision_mask = lists[random() % 5];
  };
  for (Body& body : scene.bodies) draw(body);
  for (Plane& plane : scene.planes) draw(plane);
}

// Random tables of materials over a few names, "*" among them, often with the same pair twice.
TEST(Surfaces, AgreeWithMaterialOf) {
  std::mt19937 random(20260101);
  for (int trial = 0; trial < 300; ++trial) {
    Scene scene;
    const std::vector<std::string> names = {"a", "b", "c", "d", "floor", "wall", "*"};
    for (int i = 0; i < 4; ++i) {
      scene.bodies.push_back(ball(names[static_cast<std::size_t>(i)]));
      scene.bodies.back().locked = random() % 4 == 0;
      scene.bodies.back().collide = random() % 5 != 0;
    }
    scene.planes = {{.name = "floor"}, {.name = "wall"}};
    draw_groups(scene, random);
    for (std::size_t i = random() % 9; i > 0; --i)
      scene.materials.push_back(row(names[random() % 7], names[random() % 7],
                                    0.125 * static_cast<double>(random() % 3),
                                    0.25 * static_cast<double>(random() % 2)));
    expect_same_as_pair_by_pair(scene);
  }
}

// Two patterns of one pair: which counts must not depend on their order.
TEST(Surfaces, FindPairsOfWhichTwoPatternsSayOtherNumbers) {
  Scene scene;
  for (const char* name : {"a", "b", "c"}) scene.bodies.push_back(ball(name));
  scene.planes = {{.name = "floor"}};
  scene.materials = {row("*", "*", 0.1), row("a", "*", 0.2), row("*", "floor", 0.2)};
  EXPECT_FALSE(unclear_pair(scene));  // the same numbers
  scene.materials[2].restitution = 0.3;
  const auto found = unclear_pair(scene);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->disputed);
  EXPECT_EQ(found->pair, (Pair{0, world, 0}));
  scene.materials.push_back(row("a", "floor", 0.4));
  EXPECT_FALSE(unclear_pair(scene));
  scene.materials.pop_back();
  scene.bodies[0].collision_groups = {"x"}, scene.planes[0].collision_mask = {"default"};
  EXPECT_FALSE(unclear_pair(scene));  // they never touch
  scene.materials = {row("a", "*", 0.2)};
  ASSERT_TRUE(unclear_pair(scene));
  EXPECT_FALSE(unclear_pair(scene)->disputed);
}

// 10^5 bodies of which every second was named in a material of its own, all with the same numbers.
TEST(Surfaces, AreMergedForEqualMaterials) {
  Scene scene;
  for (int i = 0; i < 100'000; ++i) scene.bodies.push_back(ball("b" + std::to_string(i)));
  scene.planes = {{.name = "floor"}};
  scene.materials = {row("*", "*", 0.1)};
  for (int i = 0; i < 100'000; i += 2)
    scene.materials.push_back(row("b" + std::to_string(i), "floor", 0.7, 0.3));
  const Surfaces classes = surfaces(scene);
  EXPECT_EQ(classes.count, 3);
  const int floor = classes.of_plane[0];
  const auto restitution = [&](int one, int other) {
    return scene.materials[static_cast<std::size_t>(classes.material(one, other))].restitution;
  };
  EXPECT_EQ(restitution(classes.of_body[4], floor), 0.7);
  EXPECT_EQ(restitution(classes.of_body[5], floor), 0.1);
  EXPECT_EQ(restitution(classes.of_body[4], classes.of_body[6]), 0.1);
  EXPECT_EQ(pair_without_material(scene), std::nullopt);
  scene.materials.erase(scene.materials.begin());
  EXPECT_EQ(pair_without_material(scene), (Pair{0, 1, -1}));
}

TEST(TouchingPairs, OfOneBodyAreThoseOfTheWholeList) {
  Scene scene;
  scene.bodies = {ball("a"), ball("ghost"), ball("b"), ball("wall"), ball("pillar")};
  scene.bodies[1].collide = false;
  scene.bodies[3].locked = scene.bodies[4].locked = true;
  scene.planes = {{.name = "floor"}, {.name = "side"}};
  for (int body = 0; body < 5; ++body) {
    std::vector<Pair> expected;
    for (const Pair& pair : touching_pairs(scene))
      if (pair.body == body || pair.other == body) expected.push_back(pair);
    // By the other body, then by plane; the whole list is by the first body.
    EXPECT_EQ(touching_pairs(scene, body).size(), expected.size());
    for (const Pair& pair : touching_pairs(scene, body))
      EXPECT_NE(std::find(expected.begin(), expected.end(), pair), expected.end());
  }
  int seen = 0;
  EXPECT_TRUE(any_touching_pair(scene, [&](const Pair&) { return ++seen == 3; }));
  EXPECT_EQ(seen, 3);
  EXPECT_FALSE(any_touching_pair(scene, [](const Pair&) { return false; }));
}

}  // namespace
