// What a format cannot say is an error at its line, and nothing is written.
#include "harness/exports/exports.h"

#include "harness/core/input_error.h"

#include <gtest/gtest.h>

#include <string>

namespace cylon::exports {
namespace {

// Line 1 is the title.
constexpr const char* head = R"(title    = "bad"
duration = 1.0
step     = 0.001
gravity  = [0.0, -9.81, 0.0]
[[body]]
name = "a"
position = [0.0, 1.0, 0.0]
mass = 1.0
inertia = [1.0, 1.0, 1.0]
[[body]]
name = "b"
position = [0.0, 3.0, 0.0]
mass = 1.0
inertia = [1.0, 1.0, 1.0]
)";
constexpr const char* tail = R"(
[[claim]]
conserves = "energy"
measure   = "increase"
tolerance = {relative = 0.01, reason = "convention: a hundredth"}
)";

struct Case {
  const char *format, *text, *says;
};

class Unsaid : public testing::TestWithParam<Case> {};

TEST_P(Unsaid, IsAnErrorAtItsLine) {
  const std::string text = std::string(head) + GetParam().text + tail;
  try {
    export_scenario(scenario::parse(text, "bad.toml"), text, GetParam().format);
    FAIL() << GetParam().says;
  } catch (const core::InputError& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().says), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Parts, Unsaid,
    testing::Values(
        Case{"MJCF", "[[spring]]\nbody = \"a\"\nto = \"b\"\nstiffness = 3.0\nrest_length = 1.0\n",
             "bad.toml:15:1: MJCF cannot say spring of 'a': it has no such force"},
        Case{"SDFormat", "[[drag]]\nbody = \"b\"\nlinear = 0.1\n",
             "bad.toml:15:1: SDFormat cannot say drag of 'b'"},
        Case{"MJCF",
             "[[joint]]\ntype = \"screw\"\nbody = \"a\"\npoint = [0.0, 1.0, 0.0]\naxis = [0.0, 1.0, "
             "0.0]\npitch = 0.1\n",
             "bad.toml:16:8: MJCF cannot say 'type' of joint of 'a': it has no screw joint"},
        Case{"SDFormat",
             "[[joint]]\ntype = \"cylindrical\"\nbody = \"a\"\npoint = [0.0, 1.0, 0.0]\naxis = [0.0, 1.0, "
             "0.0]\n",
             "bad.toml:16:8: SDFormat cannot say 'type' of joint of 'a': it has no cylindrical joint"},
        Case{"SDFormat",
             "[[joint]]\ntype = \"rectangular\"\nbody = \"a\"\npoint = [0.0, 1.0, 0.0]\naxis = [0.0, 1.0, "
             "0.0]\naxis_2 = [1.0, 0.0, 0.0]\n",
             "bad.toml:16:8: SDFormat cannot say 'type' of joint of 'a': it has no rectangular joint"},
        Case{"SDFormat",
             "[[joint]]\ntype = \"offset_universal\"\nbody = \"a\"\npoint = [0.0, 1.0, 0.0]\naxis = [0.0, "
             "1.0, "
             "0.0]\naxis_2 = [1.0, 0.0, 0.0]\nlength = 0.1\n",
             "bad.toml:16:8: SDFormat cannot say 'type' of joint of 'a': it has no offset_universal joint"},
        Case{"SDFormat",
             "[[joint]]\ntype = \"gimbal\"\nbody = \"a\"\npoint = [0.0, 1.0, 0.0]\naxis = [0.0, 1.0, "
             "0.0]\naxis_2 = [1.0, 0.0, 0.0]\nangle = [{damping = 0.1}]\n",
             "bad.toml:16:8: SDFormat cannot say 'type' of joint of 'a': it has no gimbal joint"},
        Case{"MJCF",
             "[[joint]]\ntype = \"slider\"\nbody = \"a\"\npoint = [0.0, 1.0, 0.0]\naxis = [0.0, 1.0, 0.0]\n"
             "displacement = [{lower = -1.0, upper = 1.0, restitution = 0.5}]\n",
             "bad.toml:20:16: MJCF cannot say 'displacement' of joint of 'a': a restitution"},
        Case{"MJCF",
             "[[joint]]\ntype = \"slider\"\nbody = \"a\"\npoint = [0.0, 1.0, 0.0]\naxis = [0.0, 1.0, 0.0]\n"
             "displacement = [{lower = -1.0}]\n",
             "bad.toml:20:16: MJCF cannot say 'displacement' of joint of 'a': a limit on one side"},
        Case{"SDFormat",
             "[[joint]]\ntype = \"hinge\"\nbody = \"a\"\npoint = [0.0, 1.0, 0.0]\naxis = [0.0, 1.0, 0.0]\n"
             "angle = [{force = 2.0}]\n",
             "bad.toml:20:9: SDFormat cannot say 'angle' of joint of 'a': force"},
        Case{"MJCF",
             "[[joint]]\ntype = \"hinge\"\nbody = \"a\"\npoint = [0.0, 1.0, 0.0]\naxis = [0.0, 1.0, 0.0]\n"
             "angle = [{stiffness = 2.0, target_amplitude = 0.1, target_frequency = 3.0}]\n",
             "bad.toml:20:9: MJCF cannot say 'angle' of joint of 'a': a target that moves"},
        Case{"SDFormat", "velocity = [1.0, 0.0, 0.0]\n",
             "bad.toml:15:12: SDFormat cannot say 'velocity' of body of 'b'"},
        Case{"SDFormat", "gravity = [1.0, 0.0, 0.0]\n",
             "bad.toml:15:11: SDFormat cannot say 'gravity' of body of 'b'"},
        Case{"MJCF", "gravity = [1.0, 0.0, 0.0]\n",
             "bad.toml:15:11: MJCF cannot say 'gravity' of body of 'b'"},
        Case{"MJCF", "shape = {type = \"cone\", radius = 0.1, length = 0.3}\ncollide = false\n",
             "bad.toml:15:9: MJCF cannot say 'shape' of body of 'b'"},
        Case{"MJCF", "[frame]\nvelocity = [1.0, 0.0, 0.0]\n", "bad.toml:15:1: MJCF cannot say [frame]"},
        Case{"SDFormat",
             "shape = {type = \"sphere\", radius = 0.1}\ncollision_groups = [\"x\"]\n[[material]]\nbetween = "
             "[\"*\", \"*\"]\nfriction = 0.1\nrestitution = 0.0\n",
             "bad.toml:16:20: SDFormat cannot say 'collision_groups' of body of 'b'"},
        Case{"MJCF",
             "shape = {type = \"sphere\", radius = 0.1}\n[[plane]]\nname = \"floor\"\n[[material]]\nbetween "
             "= [\"*\", \"*\"]\n"
             "friction = 0.1\nrestitution = 0.5\n",
             "bad.toml:21:15: MJCF cannot say 'restitution' of [material]: of 'b' and 'floor': its impacts "
             "are inelastic"},
        Case{"MJCF",
             "shape = {type = \"sphere\", radius = 0.1}\n[[body]]\nname = \"c\"\nposition = [1.0, 3.0, "
             "0.0]\nmass = 1.0\n"
             "shape = {type = \"sphere\", radius = 0.1}\n[[plane]]\nname = \"floor\"\n"
             "[[material]]\nbetween = [\"*\", \"*\"]\nfriction = 0.3\nrestitution = 0.0\n"
             "[[material]]\nbetween = [\"b\", \"c\"]\nfriction = 0.5\nrestitution = 0.0\n",
             "bad.toml:29:12: MJCF cannot say 'friction' of [material]: of 'b' and 'c': the format combines"},
        Case{
            "MJCF",
            "[[body]]\nname = \"world\"\nposition = [1.0, 3.0, 0.0]\nmass = 1.0\ninertia = [1.0, 1.0, 1.0]\n",
            "bad.toml:16:8: MJCF cannot say 'name' of body of 'world'"},
        // Was written, and no reader of SDFormat takes it.
        Case{
            "SDFormat",
            "[[body]]\nname = \"__c__\"\nposition = [1.0, 3.0, 0.0]\nmass = 1.0\ninertia = [1.0, 1.0, 1.0]\n",
            "bad.toml:16:8: SDFormat cannot say 'name' of body of '__c__': SDFormat keeps the name '__c__'"},
        Case{"SDFormat",
             "[[joint]]\ntype = \"hinge\"\nname = \"world\"\nbody = \"a\"\npoint = [0.0, 1.0, 0.0]\n"
             "axis = [0.0, 1.0, 0.0]\n",
             "bad.toml:17:8: SDFormat cannot say 'name' of joint of 'a': SDFormat keeps the name 'world'"},
        Case{"SDFormat",
             "[[body]]\nname = \"c::\"\nposition = [1.0, 3.0, 0.0]\nmass = 1.0\ninertia = [1.0, 1.0, 1.0]\n",
             "bad.toml:16:8: SDFormat cannot say 'name' of body of 'c::': '::' is between the names of "
             "models and links"},
        Case{"MJCF",
             "[[joint]]\ntype = \"hinge\"\nbody = \"a\"\npoint = [0.0, 1.0, 0.0]\naxis = [0.0, 1.0, 0.0]\n"
             "[[joint]]\ntype = \"hinge\"\nbody = \"a\"\nto = \"b\"\npoint = [0.0, 2.0, 0.0]\naxis = [0.0, "
             "1.0, 0.0]\n",
             "MJCF cannot say 'type' of joint of 'a': a hinge joint that closes a loop"}));

TEST(Unsaid, ImpactsAtOnceAreAnErrorAtTheirLine) {
  const std::string text = "impacts = \"simultaneous\"\n" + std::string(head) + tail;
  try {
    export_scenario(scenario::parse(text, "bad.toml"), text, "MJCF");
    FAIL();
  } catch (const core::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("bad.toml:1:11: MJCF cannot say 'impacts'"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace cylon::exports
