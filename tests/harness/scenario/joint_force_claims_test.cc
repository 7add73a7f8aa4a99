// Claims on what joints exert: how they are called, and what is refused, by its place.
#include "harness/core/input_error.h"
#include "harness/scenario/scenario.h"

#include <gtest/gtest.h>

#include <string>

namespace cylon::scenario {
namespace {

const std::string hanging =
    "duration = 1\nstep = 0.01\n"
    "[[body]]\nname = \"upper\"\nmass = 1\nposition = [0, -0.5, 0]\ninertia = [1, 2, 1.5]\n"
    "[[body]]\nname = \"lower\"\nmass = 2\nposition = [0, -1.5, 0]\ninertia = [1, 1, 1]\n"
    "[[joint]]\nname = \"hook\"\ntype = \"ball\"\nbody = \"upper\"\npoint = [0, 0, 0]\n"
    "[[joint]]\nname = \"link\"\ntype = \"ball\"\nbody = \"lower\"\nto = \"upper\"\npoint = [0, -1, 0]\n";
const std::string follows = "[[claim]]\nfollows = \"statics\"\n",
                  force = follows + "observable = \"joint_force\"\n",
                  tolerance = "tolerance = { relative = 1e-3, reason = \"convention\" }\n";

std::string refusal(const std::string& more) {
  try {
    parse(hanging + more, "bad.toml");
    return "accepted";
  } catch (const core::InputError& error) {
    return error.what();
  }
}

TEST(JointForceClaims, AreCalledByJointAndComponent) {
  const Scenario s = parse(hanging + force + "joint = \"link\"\ncomponent = \"y\"\n" + tolerance + follows +
                               "observable = \"joint_torque\"\n" + tolerance,
                           "good.toml");
  EXPECT_EQ(s.claims.at(0).label, "joint_force follows statics, link, y");
  EXPECT_EQ(s.claims.at(0).observable.joint, 1);
  EXPECT_EQ(s.claims.at(1).label, "joint_torque follows statics");
  EXPECT_FALSE(s.claims.at(1).observable.joint);
  EXPECT_LT(s.claims.at(0).truth_error, 1e-9);
}

TEST(JointForceClaims, AreRefusedByTheirPlace) {
  const struct {
    const char* name;
    std::string text, says;
  } rows[] = {
      {"right", force + tolerance, "accepted"},
      {"conserves", "[[claim]]\nconserves = \"joint_force\"\n" + tolerance,
       "conserves: joint_force belongs to 'follows'"},
      {"changes", "[[claim]]\nchanges = \"joint_torque\"\nat_least = 1\n" + tolerance,
       "changes: joint_torque belongs to 'follows'"},
      {"a balance that follows", follows + "observable = \"momentum_balance\"\n" + tolerance,
       "momentum_balance belongs to 'conserves'"},
      {"until", force + "until = 0.5\n" + tolerance, "until does not go with joint_force"},
      {"sample", force + "sample = \"step\"\n" + tolerance, "sample does not go with joint_force"},
      {"order", force + "tolerance = { order = true, constant = 1, reason = \"theory\" }\n",
       "order does not go with joint_force"},
      {"which", force + "which = \"second\"\n" + tolerance, "which belongs to coordinates of joints"},
      {"body", force + "body = \"upper\"\n" + tolerance,
       "body does not go with a quantity of joints; use 'joint'"},
      {"no such joint", force + "joint = \"hok\"\n" + tolerance,
       "no joint is named 'hok', did you mean 'hook'?"},
      {"joint of a velocity", follows + "observable = \"velocity\"\njoint = \"hook\"\n" + tolerance,
       "joint belongs to coordinates and forces of joints"},
      {"a loop",
       "[[joint]]\ntype = \"ball\"\nbody = \"lower\"\npoint = [0, -2, 0]\n" + force + "joint = \"hook\"\n" +
           tolerance,
       "of joint 'hook': joints close a loop"},
  };
  for (const auto& row : rows)
    EXPECT_NE(refusal(row.text).find(row.says), std::string::npos) << row.name << ": " << refusal(row.text);
}

}  // namespace
}  // namespace cylon::scenario
