// Two things touch only if the mask of each has a group of the other.
#include "harness/core/collision_filter.h"

#include "harness/core/equipartition.h"
#include "harness/core/observable.h"
#include "harness/core/surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

namespace cylon::core {
namespace {

using Names = std::vector<std::string>;

Body ball(const std::string& name, Names groups = {}, Names mask = {}) {
  Body body;
  body.name = name, body.shape = Sphere{0.5}, body.collide = true;
  body.collision_groups = std::move(groups), body.collision_mask = std::move(mask);
  return body;
}

struct Row {
  const char* what;
  Body a, b;
  bool touch;
};

TEST(CollisionFilter, AsksForBothMasks) {
  const Row rows[] = {
      {"neither says anything", ball("a"), ball("b"), true},
      {"a group without masks", ball("a", {"x"}), ball("b"), true},
      {"each names the other", ball("a", {"x"}, {"y"}), ball("b", {"y"}, {"x"}), true},
      {"the first alone does", ball("a", {"x"}, {"y"}), ball("b", {"y"}, {"y"}), false},
      {"the second alone does", ball("a", {"x"}, {"x"}), ball("b", {"y"}, {"x"}), false},
      {"neither does", ball("a", {"x"}, {"x"}), ball("b", {"y"}, {"y"}), false},
      {"one of several groups", ball("a", {"x", "y"}, {"z"}), ball("b", {"w", "z"}, {"y"}), true},
      {"who has no group is in default", ball("a", {}, {"x"}), ball("b", {"x"}, {"default"}), true},
      {"who has one is not", ball("a", {"y"}, {"x"}), ball("b", {"x"}, {"default"}), false},
      {"a group and default", ball("a", {"default", "y"}, {"x"}), ball("b", {"x"}, {"default"}), true},
      {"a mask of nobody's group", ball("a", {}, {"nobody"}), ball("b"), false},
      {"its own group", ball("a", {"x"}, {"x"}), ball("b", {"x"}, {"x"}), true},
  };
  for (const Row& row : rows)
    for (const bool turned : {false, true}) {
      Scene scene;
      scene.bodies = {turned ? row.b : row.a, turned ? row.a : row.b};
      EXPECT_EQ(touching_pairs(scene).size(), row.touch ? 1u : 0u) << row.what;
      EXPECT_EQ(ContactRules(scene).bodies(0, 1), row.touch) << row.what;
      // The same of a body and a plane.
      const Body& other = scene.bodies[1];
      scene.planes = {{"floor", Vector3::UnitY(), 0, other.collision_groups, other.collision_mask}};
      scene.bodies.pop_back();
      EXPECT_EQ(touching_pairs(scene, 0).size(), row.touch ? 1u : 0u) << row.what;
      EXPECT_EQ(ContactRules(scene).body_and_plane(0, 0), row.touch) << row.what;
    }
}

TEST(CollisionFilter, LeavesOtherRulesAlone) {
  Scene scene;
  scene.bodies = {ball("a"), ball("b"), ball("post"), ball("wall")};
  scene.bodies[2].locked = scene.bodies[3].locked = true;
  scene.joints = {{.body = 1, .to = 0}};
  scene.planes = {{.name = "floor"}};
  const ContactRules may_touch(scene);
  EXPECT_FALSE(may_touch.bodies(0, 1)) << "jointed";
  EXPECT_FALSE(may_touch.bodies(2, 3)) << "both locked";
  EXPECT_FALSE(may_touch.body_and_plane(2, 0)) << "locked";
  EXPECT_TRUE(may_touch.bodies(2, 0));
  EXPECT_TRUE(may_touch.body_and_plane(1, 0));
}

// What does not collide is in no group, whatever it says.
TEST(CollisionFilter, AsksOnlyThoseThatCollide) {
  Scene scene;
  scene.bodies = {ball("a", {}, {"x"}), ball("b", {"x"})};
  EXPECT_TRUE(CollisionFilters(scene).stated);
  EXPECT_EQ(CollisionFilters(scene).names, (Names{"default", "x"}));
  for (Body& body : scene.bodies) body.collide = false;
  EXPECT_FALSE(CollisionFilters(scene).stated);
  EXPECT_TRUE(states_filters(scene));
  EXPECT_TRUE(touching_pairs(scene).empty());
}

TEST(CollisionFilter, HasLimits) {
  Scene scene;
  for (std::size_t i = 1; i < most_groups; ++i) scene.bodies.push_back(ball("b", {"g" + std::to_string(i)}));
  EXPECT_NO_THROW(CollisionFilters{scene});
  // The last bit is one as the others are.
  scene.bodies.front().collision_mask = {"g" + std::to_string(most_groups - 1)};
  EXPECT_EQ(touching_pairs(scene, 0), (std::vector<Pair>{{0, static_cast<int>(most_groups) - 2, -1}}));
  scene.bodies.push_back(ball("b", {"one more"}));
  EXPECT_THROW(CollisionFilters{scene}, std::invalid_argument);
  scene.bodies.clear();
  for (unsigned i = 0; i <= most_filters; ++i) {
    scene.bodies.push_back(ball("b"));
    for (unsigned k = 0; k < 9; ++k)
      if (i >> k & 1u) scene.bodies.back().collision_groups.push_back("g" + std::to_string(k));
  }
  EXPECT_THROW(CollisionFilters{scene}, std::invalid_argument);
  scene.bodies.pop_back();
  EXPECT_NO_THROW(CollisionFilters{scene});
}

// A claim on the gap of what may not touch says so; the gap of others is that of touching pairs alone.
TEST(CollisionFilter, DecidesOfWhomAGapIs) {
  Scene scene;
  scene.bodies = {ball("a", {"x"}, {"x"}), ball("b"), ball("c")};
  scene.bodies[1].initial.position = {0.4, 0, 0};   // in a
  scene.bodies[2].initial.position = {1.37, 0, 0};  // 0.03 m in b
  const State state = initial_state(scene);
  const auto worst_gap = [&](std::optional<int> body) {
    Values values;
    evaluate({.quantity = Quantity::normal_gap, .body = body}, scene, state, values);
    double least = 0;
    for (const Eigen::Vector4d& value : values) least = std::min(least, value.x());
    return least;
  };
  EXPECT_NEAR(worst_gap(std::nullopt), -0.03, 1e-12);
  EXPECT_NEAR(worst_gap(1), -0.03, 1e-12);
  EXPECT_TRUE(undefined_in({.quantity = Quantity::normal_gap, .body = 0}, scene).has_value());
  EXPECT_FALSE(undefined_in({.quantity = Quantity::normal_gap, .body = 1}, scene).has_value());
}

// A gas whose balls do not all meet shares its energy by no law.
TEST(CollisionFilter, EndsEquipartition) {
  Scene scene;
  scene.bodies = {ball("a"), ball("b")};
  scene.materials = {{{"*", "*"}, 1, 0}};
  for (const double side : {-1., 1.})
    for (int axis = 0; axis < 3; ++axis) scene.planes.push_back({"p", side * Vector3::Unit(axis), -9});
  const Observable share{.quantity = Quantity::energy_share};
  EXPECT_EQ(energy_share_undefined(share, scene), std::nullopt);
  scene.planes[2].collision_mask = {"default"};
  EXPECT_NE(energy_share_undefined(share, scene)->find("collision groups"), std::string::npos);
}

}  // namespace
}  // namespace cylon::core
