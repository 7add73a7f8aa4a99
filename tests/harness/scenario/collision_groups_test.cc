// What groups keep apart may start inside each other, needs no material and is no contact; limits are told.
#include "harness/core/collision_filter.h"
#include "harness/core/input_error.h"
#include "harness/core/surfaces.h"
#include "harness/scenario/scenario.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace cylon::scenario {
namespace {

const std::string head = "duration = 1\nstep = 0.01\n";

std::string ball(const std::string& name, double x, const std::string& more = "") {
  return fmt::format(
      "[[body]]\nname = \"{}\"\nmass = 1\nposition = [{}, 1, 0]\nshape = {{ type = \"sphere\", radius = 0.5 "
      "}}\n{}",
      name, x, more);
}

std::string refusal(const std::string& text) {
  try {
    parse(text, "bad.toml");
    return "";
  } catch (const core::InputError& error) {
    return error.what();
  }
}

TEST(CollisionGroups, NeedNoMaterialAndNoRoomWhereTheyKeepApart) {
  const std::string apart = "collision_groups = [\"ghosts\"]\ncollision_mask = [\"walls\"]\n";
  const std::string wall =
      "[[plane]]\nname = \"wall\"\nnormal = [1, 0, 0]\noffset = -5\n"
      "collision_groups = [\"walls\"]\ncollision_mask = [\"ghosts\"]\n";
  const std::string material = "[[material]]\nbetween = [\"a\", \"wall\"]\nrestitution = 1\nfriction = 0\n";
  // Balls inside each other, and one inside a wall that it does not touch.
  const std::string two = "[[material]]\nbetween = [\"b\", \"deep\"]\nrestitution = 1\nfriction = 0\n";
  const std::string text = head + ball("a", 0, apart) + ball("b", 0.3) + ball("deep", -5.1) + wall + material;
  const core::Scene scene = parse(text + two, "good.toml").scene;
  EXPECT_EQ(core::touching_pairs(scene).size(), 2u);  // a and the wall, b and deep
  EXPECT_EQ(refusal(text),
            "bad.toml:10:1: 'b' and 'deep' may touch, but no [[material]] says how; add between = [\"b\", "
            "\"deep\"], collide = false or collision_mask");
}

TEST(CollisionGroups, OverlapOnlyWhereTheyMeet) {
  const std::string material = "[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 1\nfriction = 0\n";
  const std::string ghost = "collision_groups = [\"a\"]\ncollision_mask = [\"a\"]\n";
  EXPECT_EQ(refusal(head + ball("x", 0, ghost) + ball("y", 0.9) + material), "");
  EXPECT_NE(refusal(head + ball("x", 0, ghost) + ball("y", 0.9, ghost) + material).find("overlap by 0.09999"),
            std::string::npos);
  const std::string floor = "[[plane]]\nname = \"floor\"\noffset = 0.7\n";
  EXPECT_NE(refusal(head + ball("x", 0) + floor + material).find("into plane 'floor'"), std::string::npos);
  EXPECT_EQ(refusal(head + ball("x", 0, ghost) + floor + material), "");
}

// Neighbours in a mechanism do not touch each other, and were refused where both are spheres.
TEST(CollisionGroups, SpheresThatAJointTiesMayOverlap) {
  const std::string material = "[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 1\nfriction = 0\n";
  const std::string both = head + ball("x", 0) + ball("y", 0.9) + material;
  EXPECT_NE(refusal(both).find("overlap by 0.09999"), std::string::npos);
  const std::string joint = "[[joint]]\ntype = \"ball\"\nbody = \"y\"\nto = \"x\"\npoint = [0, 0.5, 0]\n";
  EXPECT_EQ(refusal(both + joint), "");
  EXPECT_NE(refusal(both + ball("z", 1.8) + joint).find("'y' and 'z' overlap"), std::string::npos);
}

TEST(CollisionGroups, OfGeneratorsAreThoseOfTheirBodies) {
  const core::Scene scene =
      parse(head +
                "[[lattice]]\nname = \"l\"\nmass = 1\ncount = [2, 1, 1]\nspacing = [0.2, 0, 0]\n"
                "shape = { type = \"sphere\", radius = 0.5 }\ncollision_groups = [\"l\"]\ncollision_mask = "
                "[\"default\"]\n" +
                ball("a", 5) + "[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 1\nfriction = 0\n",
            "good.toml")
          .scene;
  EXPECT_EQ(scene.bodies[1].name, "l[0]");
  EXPECT_EQ(core::touching_pairs(scene), (std::vector<core::Pair>{{0, 1, -1}, {0, 2, -1}}));
}

TEST(CollisionGroups, HaveLimits) {
  const std::string material = "[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 1\nfriction = 0\n";
  std::string text = head;
  for (std::size_t i = 1; i < core::most_groups; ++i)
    text += ball(fmt::format("b{}", i), 2. * static_cast<double>(i),
                 fmt::format("collision_groups = [\"g{}\"]\n", i));
  EXPECT_EQ(refusal(text + material), "");
  EXPECT_NE(refusal(text + ball("last", 0, "collision_groups = [\"more\"]\n") + material)
                .find("'more' is one group too many; valid: 32 groups in a scene"),
            std::string::npos);
  text = head;
  for (unsigned i = 0; i <= core::most_filters; ++i) {
    std::string groups = "\"g\"";
    for (unsigned k = 0; k < 9; ++k)
      if (i >> k & 1u) groups += fmt::format(", \"g{}\"", k);
    text += ball(fmt::format("b{}", i), 2. * i, fmt::format("collision_groups = [{}]\n", groups));
  }
  EXPECT_NE(refusal(text + material).find("at most 256 different pairs of collision groups and mask"),
            std::string::npos);
}

}  // namespace
}  // namespace cylon::scenario
