// A second joint that asks for what the reduced coordinates of a hinged body keep already left a row of rounding, which was
// divided by: NaN, a body that stopped dead, or no end.
#include "tests/harness/cli/fixture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace cylon::cli {
namespace {

using RedundantJoints = CommandLine;

// A box at the origin that swings from the first joint; the second lies on the same axis.
std::string scene(const std::string& first, const std::string& second) {
  const std::string head =
      "duration = 0.5\nstep = 0.001\ngravity = [0.7, -9.6, 1.9]\n[[body]]\nname = \"door\"\nmass = 1.2\n"
      "shape = { type = \"box\", half_extents = [0.2, 0.12, 0.3] }\n";
  const auto joint = [](const std::string& what) { return "[[joint]]\nbody = \"door\"\n" + what; };
  return head + joint(first) + joint(second);
}

std::vector<double> numbers(const std::string& csv) {
  std::istringstream lines(csv.substr(csv.find('\n') + 1));
  std::vector<double> all;
  std::string word;
  for (int column = 0; std::getline(lines, word, ','); ++column)
    if (column > 1) all.push_back(std::stod(word));
  return all;
}

TEST_F(RedundantJoints, MoveAsConstraints) {
  const std::string axis = "axis = [0.6, 0.48, 0.64]\n", at = "point = [0.3, 0.2, -0.1]\n",
                    along = "point = [0.54, 0.392, 0.156]\n";
  const std::string hinge = "type = \"hinge\"\n" + at + axis, ball = "type = \"ball\"\n" + at;
  const std::pair<std::string, std::string> pairs[] = {
      {hinge, "type = \"hinge\"\n" + along + axis},
      {hinge, "type = \"ball\"\n" + along},
      {hinge, "type = \"cylindrical\"\n" + along + axis},
      {hinge, "type = \"planar\"\n" + along + axis + "axis_2 = [0.8, -0.36, -0.48]\n"},
      {ball, "type = \"ball\"\n" + at},
      {"type = \"distance\"\npoint = [0.3, 0.2, -0.1]\n", "type = \"distance\"\npoint = [0.3, 0.2, -0.1]\n"}};
  int k = 0;
  for (const auto& [first, second] : pairs) {
    write("scene.toml", scene(first, second));
    const auto moved = [&](const std::string& engine) {
      const Ran ran = cylon("simulate scene.toml --at 0.5 --engine " + engine);
      EXPECT_EQ(ran.code, 0) << k << ran.err;
      return numbers(ran.out);
    };
    const std::vector<double> reduced = moved("in-house"), constrained = moved("in-house/joints=constraints"),
                              steps = moved("in-house/integrator=rk4");
    ASSERT_EQ(reduced.size(), 13u) << k;
    ASSERT_EQ(constrained.size(), 13u) << k;
    ASSERT_EQ(steps.size(), 13u) << k;
    double speed = 0;
    for (std::size_t i = 0; i < 13; ++i) {
      EXPECT_NEAR(reduced[i], constrained[i], 1e-8) << k << ", " << i;
      EXPECT_NEAR(steps[i], constrained[i], 1e-6) << k << ", " << i;
      if (i >= 7) speed += std::abs(constrained[i]);
    }
    EXPECT_GT(speed, 0.1) << k;
    ++k;
  }
}

// A door on two hinges is one on one hinge: with all that may act along the angle, and struck by a ball.
TEST_F(RedundantJoints, DoorOnTwoHingesIsADoorOnOne) {
  const std::string axis = "axis = [0.6, 0.48, 0.64]\n",
                    hinge = "type = \"hinge\"\npoint = [0.3, 0.2, -0.1]\n" + axis,
                    other =
                        "[[joint]]\nbody = \"door\"\ntype = \"hinge\"\npoint = [0.54, 0.392, 0.156]\n" + axis;
  const auto law = [](double friction, const std::string& more) {
    return fmt::format("[[joint.angle]]\nfriction = {}\nrestitution = 0.4\n{}", friction, more);
  };
  const std::string spring = "stiffness = 3\ndamping = 0.05\nupper = 0.6\n",
                    rotor = "armature = 0.05\nlower = -0.7\n";
  const std::string ball =
      "[[body]]\nname = \"ball\"\nmass = 0.4\nposition = [-0.15, 0.45, 0.1]\nvelocity = [0, -3, 0]\n"
      "shape = { type = \"sphere\", radius = 0.1 }\n[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = "
      "0.6\n"
      "friction = 0.3\n";
  const std::pair<std::string, std::string> pairs[] = {
      {hinge + law(0.1, spring) + other + law(0.05, rotor), hinge + law(0.15, spring + rotor)},
      {hinge + other + ball, hinge + ball}};
  for (const auto& [two, one] : pairs) {
    const auto end = [&](const std::string& joints) {
      write(
          "door.toml",
          "duration = 0.5\nstep = 0.001\ngravity = [0.7, -9.6, 1.9]\n[[body]]\nname = \"door\"\nmass = 1.2\n"
          "shape = { type = \"box\", half_extents = [0.2, 0.12, 0.3] }\n[[joint]]\nbody = \"door\"\n" +
              joints);
      const Ran ran = cylon("simulate door.toml --at 0.5 --engine in-house");
      EXPECT_EQ(ran.code, 0) << ran.err;
      return numbers(ran.out.substr(0, ran.out.find('\n', ran.out.find('\n') + 1)));
    };
    const std::vector<double> redundant = end(two), plain = end(one);
    ASSERT_EQ(redundant.size(), 13u);
    ASSERT_EQ(plain.size(), 13u);
    for (std::size_t i = 0; i < 13; ++i) EXPECT_NEAR(redundant[i], plain[i], 1e-9) << i;
  }
}

// A planar four-bar of hinges whose axis is none of the world's, above a floor that it does not reach.
std::string four_bar(const char* step, bool may_touch) {
  const std::string axis = "axis = [-0.5850042574449247, 0.0, 0.8110302206276362]\n";
  const auto joint = [&](const char* body, const char* to, const char* point) {
    return fmt::format("[[joint]]\ntype = \"hinge\"\nbody = \"{}\"\n{}point = {}\n{}", body, to, point, axis);
  };
  const auto link = [&](const char* name, double mass, const char* position) {
    return fmt::format(
        "[[body]]\nname = \"{}\"\nmass = {}\nposition = {}\n"
        "shape = {{ type = \"box\", half_extents = [0.1, 0.12, 0.08] }}\n{}",
        name, mass, position, may_touch ? "" : "collide = false\n");
  };
  return fmt::format("duration = 0.5\nstep = \"{}\"\ngravity = [0, -9.81, 0]\n", step) +
         link("l0", 0.7618, "[-0.03872669303496963, 1.04525, -0.027933953292995153]") +
         link("l1", 1.8075, "[0.2987835332792212, 1.2471, 0.21551556844271025]") +
         link("l2", 1.3159, "[0.7787917693576877, 1.02215, 0.5617503382114889]") +
         joint("l0", "", "[0.0, 0.8, 0.0]") +
         joint("l1", "to = \"l0\"\n", "[-0.07745338606993926, 1.2905, -0.05586790658599031]") +
         joint("l2", "to = \"l1\"\n", "[0.6750204526283816, 1.2037, 0.48689904347141083]") +
         joint("l2", "", "[0.8825630860869937, 0.8406, 0.636601632951567]") +
         "[[plane]]\nname = \"floor\"\noffset = 0.4\n[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = "
         "0\n"
         "friction = 0.3\n";
}

// Rows of such a loop depend on each other but for rounding.  In fixed steps their impulses balanced each other and grew
// from step to step: links were 4 cm off, or flung away.
TEST_F(RedundantJoints, LoopsMoveInStepsAsTheyDoAlone) {
  const auto end = [&](const char* step, bool may_touch) {
    write("loop.toml", four_bar(step, may_touch));
    const Ran ran = cylon(std::string("simulate loop.toml --at 0.5 --engine in-house") +
                          (may_touch ? "/path=stepping" : ""));
    EXPECT_EQ(ran.code, 0) << ran.err;
    return numbers(ran.out.substr(0, ran.out.find('\n', ran.out.find('\n') + 1)));  // of the first link
  };
  const std::vector<double> right = end("1/1000", false);
  ASSERT_EQ(right.size(), 13u);
  const auto error = [&](const char* step) {
    const std::vector<double> got = end(step, true);
    double worst = 0;
    for (std::size_t i = 0; i < 3 && i < got.size(); ++i)
      worst = std::max(worst, std::abs(got[i] - right[i]));
    EXPECT_EQ(got.size(), 13u);
    return worst;
  };
  const double coarse = error("1/500"), fine = error("1/2000");
  EXPECT_LT(coarse, 1e-4);
  EXPECT_LT(fine, coarse / 8);  // of second order
}

}  // namespace
}  // namespace cylon::cli
