// Joints in files: what is read of them, and what is refused, by its place.
#include "harness/core/fields.h"
#include "harness/core/input_error.h"
#include "harness/process/scene_json.h"
#include "harness/scenario/scenario.h"
#include "harness/scenario/writer.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace cylon::scenario {
namespace {

const std::string head =
    "duration = 1\nstep = 0.01\n"
    "[[body]]\nname = \"a\"\nmass = 1\ninertia = [1, 2, 1.5]\n"
    "[[body]]\nname = \"b\"\nmass = 2\nposition = [1, 0, 0]\ninertia = [1, 1, 1]\n";

std::string joint(const std::string& type, const std::string& more = "") {
  return fmt::format("[[joint]]\ntype = \"{}\"\nbody = \"a\"\nto = \"b\"\npoint = [0.5, 0, 0]\n{}", type,
                     more);
}
const std::string along = "axis = [0, 0, 2]\n", two = along + "axis_2 = [3, 0, 0]\n";

std::string refusal(const std::string& text) {
  try {
    parse(text, "bad.toml");
    return "accepted";
  } catch (const core::InputError& error) {
    return error.what();
  }
}

TEST(Joints, EveryKindIsRead) {
  struct Case {
    std::string type, keys;
  };
  const Case cases[] = {
      {"ball", ""},    {"hinge", along},       {"fixed", ""},      {"slider", along},
      {"planar", two}, {"cylindrical", along}, {"universal", two}, {"screw", along + "pitch = -0.02\n"}};
  for (const Case& c : cases) {
    const core::Scene scene = parse(head + joint(c.type, c.keys + "name = \"elbow\"\n"), "good.toml").scene;
    const core::Joint& read = scene.joints.at(0);
    EXPECT_EQ(core::kind_of(read.type).name, c.type);
    EXPECT_EQ(read.name, "elbow");
    if (core::kind_of(read.type).has_axis()) {
      EXPECT_EQ(read.axis, core::Vector3(0, 0, 1)) << c.type;
    }
    EXPECT_EQ(read.axis_2.has_value(), core::kind_of(read.type).has_second_axis()) << c.type;
    EXPECT_EQ(read.pitch, c.type == "screw" ? -0.02 : 0);
  }
}

const std::string all_keys =
    "start = 0.1\nlower = -1\nupper = 2\nrestitution = 0.5\nforce = 3\nstiffness = 4\ndamping = 5\n"
    "quadratic_damping = 6\nfriction = 7\narmature = 9\ntarget = 0.2\ntarget_amplitude = "
    "0.3\ntarget_frequency = 8\n"
    "target_phase = 0.4\n";

TEST(Joints, CoordinatesAreReadWrittenAndSent) {
  const std::string text =
      head + joint("planar", two + "[[joint.displacement]]\nwhich = \"second\"\n" + all_keys +
                                 "[[joint.angle]]\nstiffness = 1\ntarget_times = [0, 0.5]\n"
                                 "target_values = [0, 1]\n");
  const core::Scene scene = parse(text, "good.toml").scene;
  const core::Joint& read = scene.joints.at(0);
  ASSERT_EQ(read.displacements.size(), 1u);
  ASSERT_EQ(read.angles.size(), 1u);
  const core::JointCoordinate& c = read.displacements[0];
  EXPECT_EQ(c.which, core::Ordinal::second);
  EXPECT_EQ(c.start, 0.1);
  EXPECT_EQ(c.lower, -1);
  EXPECT_EQ(c.upper, 2);
  EXPECT_EQ(c.restitution, 0.5);
  EXPECT_EQ(c.force, 3);
  EXPECT_EQ(c.stiffness, 4);
  EXPECT_EQ(c.damping, 5);
  EXPECT_EQ(c.quadratic_damping, 6);
  EXPECT_EQ(c.friction, 7);
  EXPECT_EQ(c.armature, 9);
  EXPECT_EQ(c.target, 0.2);
  EXPECT_EQ(c.target_amplitude, 0.3);
  EXPECT_EQ(c.target_frequency, 8);
  EXPECT_EQ(c.target_phase, 0.4);
  EXPECT_EQ(read.angles[0].target_times, (std::vector<double>{0, 0.5}));
  EXPECT_FALSE(read.angles[0].lower || read.angles[0].upper);

  const core::Scene written = parse("duration = 1\nstep = 0.01\n" + to_toml(scene), "written.toml").scene;
  EXPECT_EQ(process::to_json(written), process::to_json(scene));
  const nlohmann::json sent = process::to_json(scene);
  EXPECT_EQ(process::to_json(process::scene_from_json(sent)), sent);
  EXPECT_EQ(sent["joint"][0]["displacement"][0]["upper"], 2);
}

// Engines of 0.2 know none of these keys.
TEST(Joints, OlderKindsAreSentAsBefore) {
  for (const auto& [type, keys] : {std::pair<std::string, std::string>{"ball", ""}, {"hinge", along}}) {
    const nlohmann::json sent =
        process::to_json(parse(head + joint(type, keys), "good.toml").scene)["joint"][0];
    for (const char* key : {"name", "axis_2", "pitch", "displacement", "angle"})
      EXPECT_FALSE(sent.contains(key)) << type << " " << key;
    EXPECT_EQ(sent.size(), 6u) << sent;
  }
}

TEST(Joints, WhatMakesNoSenseIsRefusedByItsPlace) {
  struct Case {
    std::string text, complaint;
  };
  const std::string slide = "[[joint.displacement]]\n";
  const Case cases[] = {
      {joint("screw", along + "pitch = 0\n"), "bad.toml:18:9: pitch = 0: a screw without pitch is a hinge"},
      {joint("screw", along), "[[joint]] needs 'pitch'"},
      {joint("slider", along + "pitch = 1\n"), "unknown key 'pitch' in [[joint]]"},
      {joint("universal", along + "axis_2 = [0, 1, 1]\n"),
       "bad.toml:18:10: axis_2 = [0, 1, 1] is not square to axis = [0, 0, 2]"},
      {joint("universal", along + "axis_2 = [0, 0, 0]\n"), "axis_2 = [0, 0, 0] has no direction"},
      {joint("universal", along), "[[joint]] needs 'axis_2'"},
      {joint("hinge", along + slide + "force = 1\n"), "unknown key 'displacement'"},
      {joint("ball", "[[joint.angle]]\ndamping = 1\n"), "unknown key 'angle'"},
      {joint("slider", along + slide + "which = \"second\"\nforce = 1\n"),
       "which = \"second\", but a slider joint has one displacement"},
      {joint("slider", along + slide + "force = 1\n" + slide + "damping = 1\n"),
       "the first displacement is stated twice"},
      {joint("slider", along + slide + "lower = 1\nupper = -1\n"),
       "bad.toml:20:9: upper = -1: must be > lower = 1"},
      {joint("slider", along + slide + "lower = 0.5\nstart = 0.2\n"),
       "start = 0.2: outside of the limits 0.5 and inf"},
      {joint("slider", along + slide + "restitution = 0.5\n"), "restitution belongs to 'lower' and 'upper'"},
      {joint("slider", along + slide + "lower = 0\nrestitution = 1.5\n"), "restitution = 1.5"},
      {joint("slider", along + slide + "stiffness = -1\n"), "stiffness = -1"},
      {joint("slider", along + slide + "target = 1\n"), "target belongs to 'stiffness' and 'damping'"},
      {joint("slider", along + slide + "stiffness = 2\ntarget_frequency = 3\n"),
       "target_frequency belongs to 'target_amplitude'"},
      {joint("slider", along + slide + "stiffness = 1\ntarget_times = [0, 1]\n"),
       "target_times and target_values"},
      {joint("slider", along + slide + "stiffness = 1\ntarget_times = [0, 0]\ntarget_values = [1, 2]\n"),
       "target_times[1] = 0: must be later than 0"},
      {joint("slider", along + slide + "stiffness = 1\ntarget_times = [0, 1]\ntarget_values = [1]\n"),
       "1 target_values for 2 target_times"},
      {joint("slider",
             along + slide + "stiffness = 1\ntarget = 1\ntarget_times = [0, 1]\ntarget_values = [1, 2]\n"),
       "target does not go with 'target_times'"},
      {joint("hinge", along + "name = \"x\"\n") + joint("ball", "name = \"x\"\n"),
       "two joints are named 'x'"},
      {"[[joint]]\ntype = \"slider\"\nbody = \"a\"\nto = \"a\"\npoint = [0, 0, 0]\n" + along,
       "a joint joins two different bodies"},
  };
  for (const Case& c : cases)
    EXPECT_NE(refusal(head + c.text).find(c.complaint), std::string::npos)
        << c.text << "\nsays: " << refusal(head + c.text);
}

// Initial velocities: what a joint forbids is refused with what it would allow.
TEST(Joints, VelocitiesMustBeAllowed) {
  const auto moving = [](const std::string& type, const std::string& keys, const std::string& motion) {
    return "duration = 1\nstep = 0.01\n[[body]]\nname = \"a\"\nmass = 1\ninertia = [1, 2, 1.5]\n" + motion +
           fmt::format("[[joint]]\ntype = \"{}\"\nbody = \"a\"\npoint = [0, 0, 0]\n{}", type, keys);
  };
  const std::string screw = along + "pitch = 0.5\n";
  EXPECT_EQ(refusal(moving("slider", along, "velocity = [0, 0, 3]\n")), "accepted");
  EXPECT_NE(refusal(moving("slider", along, "velocity = [0.1, 0, 3]\n")).find("breaks the slider joint"),
            std::string::npos);
  EXPECT_NE(refusal(moving("slider", along, "angular_velocity = [0, 0, 1]\n")).find("angular_velocity"),
            std::string::npos);
  EXPECT_EQ(refusal(moving("cylindrical", along, "velocity = [0, 0, 3]\nangular_velocity = [0, 0, 1]\n")),
            "accepted");
  EXPECT_EQ(refusal(moving("screw", screw, "velocity = [0, 0, 1]\nangular_velocity = [0, 0, 2]\n")),
            "accepted");
  EXPECT_NE(refusal(moving("screw", screw, "velocity = [0, 0, 1]\nangular_velocity = [0, 0, 1]\n"))
                .find("consistent"),
            std::string::npos);
  EXPECT_EQ(refusal(moving("planar", two, "velocity = [1, 2, 0]\nangular_velocity = [0, 0, 2]\n")),
            "accepted");
  EXPECT_NE(refusal(moving("planar", two, "velocity = [1, 2, 1]\n")).find("breaks the planar"),
            std::string::npos);
  EXPECT_EQ(refusal(moving("universal", two, "angular_velocity = [1, 0, 2]\n")), "accepted");
  EXPECT_NE(refusal(moving("universal", two, "angular_velocity = [1, 1, 2]\n")).find("breaks the universal"),
            std::string::npos);
  // What an export and an import leave of a body at rest beside one that moves: it was refused.
  const std::string other = "[[body]]\nname = \"b\"\nmass = 1\ninertia = [1, 1, 1]\nvelocity = [1, 0, 0]\n";
  const std::string residue = moving("universal", two, "velocity = [0, 7e-18, 0]\n");
  EXPECT_EQ(refusal(residue + other), "accepted");
  EXPECT_NE(refusal(residue).find("breaks the universal"), std::string::npos);
}

// A spin of 1e-18 rad/s beside a speed, or a speed beside a spin, was the whole scale of what is rounding, and refused.
TEST(Joints, RoundingOfSpinsIsMeasuredBySpeedsToo) {
  const auto moving = [](const std::string& type, const std::string& motion) {
    return "duration = 1\nstep = 0.01\n[[body]]\nname = \"a\"\nmass = 1\ninertia = [1, 2, 1.5]\n" + motion +
           fmt::format("[[joint]]\ntype = \"{}\"\nbody = \"a\"\npoint = [0, 0, 0]\n{}", type, along);
  };
  const std::string fast = "velocity = [0, 0, 0.4]\nangular_velocity = [{}, 0, 0]\n";
  EXPECT_EQ(refusal(moving("slider", fmt::format(fmt::runtime(fast), 3e-18))), "accepted");
  EXPECT_NE(refusal(moving("slider", fmt::format(fmt::runtime(fast), 3e-10))).find("breaks the slider"),
            std::string::npos);
  // A needle beside it is no scale of its turns.
  const std::string needle = "[[body]]\nname = \"b\"\nmass = 1\ninertia = [1e-20, 1e-20, 1e-20]\n";
  EXPECT_NE(
      refusal(moving("slider", fmt::format(fmt::runtime(fast), 3e-10)) + needle).find("breaks the slider"),
      std::string::npos);
  const std::string turning = "velocity = [{}, 0, 0]\nangular_velocity = [0, 0, 2]\n";
  EXPECT_EQ(refusal(moving("hinge", fmt::format(fmt::runtime(turning), 3e-18))), "accepted");
  EXPECT_NE(refusal(moving("hinge", fmt::format(fmt::runtime(turning), 3e-10))).find("breaks the hinge"),
            std::string::npos);
}

TEST(Joints, ClaimsNameThem) {
  const std::string claim =
      "[[claim]]\nconserves = \"joint_angle\"\njoint = \"{}\"\ntolerance = {{ absolute = 1e-6, reason = "
      "\"rounding\" "
      "}}\n";
  const std::string text = head + joint("hinge", along + "name = \"elbow\"\n");
  const Scenario good = parse(text + fmt::format(fmt::runtime(claim), "elbow"), "good.toml");
  EXPECT_EQ(good.claims.at(0).observable.joint, 0);
  EXPECT_EQ(good.claims.at(0).label, "joint_angle conserved, elbow");
  EXPECT_NE(refusal(text + fmt::format(fmt::runtime(claim), "knee")).find("no joint is named 'knee'"),
            std::string::npos);
  const std::string slider = head + joint("slider", along + "name = \"elbow\"\n");
  EXPECT_NE(
      refusal(slider + fmt::format(fmt::runtime(claim), "elbow")).find("leaves no such coordinate free"),
      std::string::npos);
}

}  // namespace
}  // namespace cylon::scenario
