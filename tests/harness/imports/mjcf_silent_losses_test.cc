// Parts of MJCF that changed the motion without a word: each is read as MuJoCo 3.14 does (the numbers are of its
// mj_forward), or refused.
#include "tests/harness/imports/inline_model.h"

#include "harness/core/collision_filter.h"
#include "harness/core/held_joint.h"

#include <cmath>

namespace cylon::imports {
namespace {

Outcome import_mjcf(const std::string& text, const Options& options = {}) {
  return import_text("<mujoco>" + text + "</mujoco>", "xml", options);
}

int number_of(const core::Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].name == name) return static_cast<int>(i);
  ADD_FAILURE() << "no body " << name;
  return 0;
}

// <exclude> mapped bodies to those that they are welded to: a static base took the floor with it.
TEST(MjcfExclude, OfAStaticBodyLeavesTheFloor) {
  REQUIRE_IMPORT("xml");
  const Outcome outcome = import_mjcf(R"(<worldbody><geom type="plane" size="0 0 1"/>
    <body name="base" pos="0 0 0.1"><geom type="box" size=".1 .12 .13"/></body>
    <body name="ball" pos="0 0 1"><freejoint/><geom type="sphere" size=".1"/></body>
    <body name="other" pos="0 3 1"><freejoint/><geom type="sphere" size=".1"/></body></worldbody>
    <contact><exclude body1="base" body2="ball"/></contact>)");
  ASSERT_EQ(outcome.refusal, "");
  const core::Scene& scene = outcome.scene();
  const core::ContactRules rules(scene);
  const int base = number_of(scene, "base"), ball = number_of(scene, "ball"),
            other = number_of(scene, "other");
  EXPECT_TRUE(rules.body_and_plane(ball, 0));
  EXPECT_FALSE(rules.bodies(base, ball));
  EXPECT_TRUE(rules.bodies(base, other));
  EXPECT_TRUE(rules.bodies(ball, other));
}

TEST(MjcfExclude, OfAPartThatMovesIsRefused) {
  REQUIRE_IMPORT("xml");
  const Outcome outcome = import_mjcf(R"(<worldbody>
    <body name="a" pos="0 0 1"><freejoint/><geom type="sphere" size=".1"/>
      <body name="hand" pos="1 0 0"><geom name="palm" type="sphere" size=".12"/></body></body>
    <body name="ball" pos="0 3 1"><freejoint/><geom type="sphere" size=".1"/></body></worldbody>
    <contact><exclude body1="hand" body2="ball"/></contact>)");
  EXPECT_TRUE(outcome.refuses("geom 'palm': surfaces")) << outcome.refusal << outcome.left_out;
}

// A body that moves freely and hangs on one that moves has no joint in a scene, so that the two touched there.
TEST(MjcfFreeChild, DoesNotTouchItsParentAsFilterparentSays) {
  REQUIRE_IMPORT("xml");
  for (const char* turns :
       {R"(<joint type="ball"/>)", R"(<joint axis="0 0 1"/><joint axis="0 1 0"/><joint axis="1 0 0"/>)"})
    for (const bool filtered : {true, false}) {
      const Outcome outcome = import_mjcf(
          std::string(filtered ? "" : R"(<option><flag filterparent="disable"/></option>)") +
          R"(<worldbody><geom type="plane" size="0 0 1"/><body name="parent" pos="0 0 1"><freejoint/><geom size=".1"/>
          <body name="part" pos=".3 0 0"><geom size=".1"/></body>
          <body name="child" pos="0 0 .5"><joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/>
            <joint type="slide" axis="0 0 1"/>)" +
          turns + R"(<geom size=".1"/></body></body>
          <body name="other" pos="0 0 3"><freejoint/><geom size=".1"/></body></worldbody>)");
      ASSERT_EQ(outcome.refusal, "");
      const core::Scene& scene = outcome.scene();
      ASSERT_TRUE(scene.joints.empty());
      const core::ContactRules rules(scene);
      const int parent = number_of(scene, "parent"), child = number_of(scene, "child"),
                other = number_of(scene, "other");
      EXPECT_EQ(rules.bodies(parent, child), !filtered) << turns;
      EXPECT_TRUE(rules.bodies(parent, other) && rules.bodies(child, other)) << turns;
      EXPECT_TRUE(rules.body_and_plane(parent, 0) && rules.body_and_plane(child, 0)) << turns;
    }
}

// Between sites its torque scale was not read, and it held the direction too.
TEST(MjcfWeld, OfSitesWithoutATorqueIsABall) {
  REQUIRE_IMPORT("xml");
  const Outcome outcome = import_mjcf(R"(<worldbody><body name="a" pos="0 0 1"><freejoint/><geom size=".1"/>
    <site name="s" pos=".2 0 0" euler="30 0 0"/></body><body name="b" pos=".5 0 1"><freejoint/><geom size=".1"/>
    <site name="t" pos="-.3 0 0"/></body></worldbody>
    <equality><weld site1="s" site2="t" torquescale="0"/></equality>)");
  ASSERT_EQ(outcome.refusal, "");
  EXPECT_EQ(outcome.scene().joints.at(0).type, core::JointType::ball);
}

// The keyframe that gave the start was told among the losses, and --strict refused the model for it.
TEST(MjcfKeyframe, ThatGivesTheStartIsNoLoss) {
  REQUIRE_IMPORT("xml");
  const std::string ball = R"(<worldbody><body name="ball" pos="0 0 1"><freejoint/>
    <geom type="sphere" size=".1"/></body></worldbody>)";
  const std::string keys = R"(<keyframe><key name="start" qpos="0 0 2 1 0 0 0"/>
    <key name="other" qpos="0 0 3 1 0 0 0"/></keyframe>)";
  const Outcome own = import_mjcf(ball + keys), start = import_mjcf(ball + keys, {.keyframe = "start"});
  ASSERT_EQ(own.refusal + start.refusal, "");
  EXPECT_TRUE(own.leaves_out("key 'start'")) << own.left_out;
  EXPECT_FALSE(start.leaves_out("key 'start'")) << start.left_out;
  EXPECT_TRUE(start.leaves_out("key 'other'")) << start.left_out;
}

// What was dropped, and is refused now.
struct Silent {
  const char *name, *text, *says;
};
class MjcfSilent : public testing::TestWithParam<Silent> {};

TEST_P(MjcfSilent, LossIsRefused) {
  REQUIRE_IMPORT("xml");
  const Outcome outcome = import_mjcf(GetParam().text);
  EXPECT_TRUE(outcome.refuses(GetParam().says)) << outcome.refusal << outcome.left_out;
}

#define BALL R"(<geom type="sphere" size=".1" mass="1"/></body></worldbody>)"
#define HINGE                                                               \
  R"(<worldbody><body name="a" pos="0 0 1"><joint name="j" axis="0 1 0"/>)" \
  R"(<geom type="sphere" size=".1" mass="1" pos="0 0 -1"/></body></worldbody>)"

INSTANTIATE_TEST_SUITE_P(
    Parts, MjcfSilent,
    testing::Values(
        Silent{"FreeJointFriction", R"(<worldbody><body><joint name="j" type="free" frictionloss="3"/>)" BALL,
               "joint 'j': joint_friction (a free joint)"},
        Silent{"FreeJointSpring", R"(<worldbody><body><joint name="j" type="free" stiffness="30"/>)" BALL,
               "joint 'j': joint_spring (a free joint)"},
        Silent{"FreeJointCurvedDamper",
               R"(<worldbody><body><joint name="j" type="free" damping="0 3"/>)" BALL,
               "joint 'j': joint_damping (not linear)"},
        Silent{"BallCurvedDamper", R"(<worldbody><body><joint name="j" type="ball" damping="0 3"/>)" BALL,
               "joint 'j': joint_damping (not linear)"},
        Silent{"FreeDragOfAWhole",
               R"(<worldbody><body name="a"><joint type="free" damping="2"/><geom size=".1" mass="1"/>)"
               R"(<body name="b" pos="1 0 0"><geom size=".1" mass="1"/></body></body></worldbody>)",
               "body 'b': free_drag (a part of body 'a')"},
        Silent{
            "GravityOfAPart",
            R"(<worldbody><body name="a"><freejoint/><geom size=".1" mass="1"/>)"
            R"(<body name="b" pos="1 0 0" gravcomp="1"><geom size=".1" mass="1"/></body></body></worldbody>)",
            "body 'b': part_gravity (a part of body 'a')"},
        Silent{
            "TendonCurvedSpring",
            R"(<worldbody><body><joint name="j" type="slide" axis="0 0 1"/>)" BALL
            R"(<tendon><fixed name="t" stiffness="0 5" springlength="0.3"><joint joint="j" coef="1"/></fixed></tendon>)",
            "tendon 't': tendon_force"},
        // 0.5 m long, and at most 0.4.
        Silent{
            "TendonLimitAtTheStart",
            R"(<worldbody><site name="s"/><body pos="0 0 .5"><joint name="j" type="slide" axis="0 0 1"/><site name="e"/>)" BALL
            R"(<tendon><spatial name="t" range="0 .4"><site site="s"/><site site="e"/></spatial></tendon>)",
            "tendon 't': tendon_force (its limit acts at the start)"},
        Silent{"MotorCurvedDamper", HINGE R"(<actuator><motor name="m" joint="j" damping="0 3"/></actuator>)",
               "actuator 'm': joint_damping (not linear)"},
        Silent{"ActivationRange",
               HINGE R"(<actuator><intvelocity name="m" joint="j" kp="5" actrange="0.5 1"/></actuator>)",
               "actuator 'm': actuator_state (its activation changes)"},
        Silent{"BeginsAsleep",
               R"(<option><flag sleep="enable"/></option><worldbody><body sleep="init"><freejoint/>)" BALL,
               "option: unread (bodies that begin asleep: 1)"},
        Silent{"AnisotropicOverride",
               R"(<option o_friction="0.2 0.3 0.005 0.0001 0.0001"><flag override="enable"/></option>)"
               R"(<worldbody><geom name="floor" type="plane" size="0 0 1"/><body><freejoint/>)" BALL,
               "geom 'floor' and 1 more: anisotropic_friction (o_friction)"}),
    [](const auto& row) { return std::string(row.param.name); });

// What was left out without a word, and is told now.
class MjcfUntold : public testing::TestWithParam<Silent> {};

TEST_P(MjcfUntold, LossIsTold) {
  REQUIRE_IMPORT("xml");
  const Outcome outcome = import_mjcf(GetParam().text);
  EXPECT_EQ(outcome.refusal, "");
  EXPECT_TRUE(outcome.leaves_out(GetParam().says)) << outcome.left_out;
}

INSTANTIATE_TEST_SUITE_P(
    Parts, MjcfUntold,
    testing::Values(
        Silent{"MarginOfALimit",
               R"(<compiler angle="radian"/><worldbody><body>)"
               R"(<joint name="j" axis="0 1 0" range="-1 .5" limited="true" margin="0.2"/>)" BALL,
               "joint 'j': limit_margin (0.2 rad)"},
        Silent{"Solver",
               R"(<option integrator="RK4" noslip_iterations="3"/><worldbody><body><freejoint/>)" BALL,
               "option: solver (integrator)"},
        Silent{"SolverFlag",
               R"(<option><flag refsafe="disable"/></option><worldbody><body><freejoint/>)" BALL,
               "option: solver (mjDSBL_REFSAFE)"},
        Silent{"DisabledActuation",
               R"(<option><flag actuation="disable"/></option>)" HINGE
               R"(<actuator><motor name="m" joint="j"/></actuator>)",
               "actuator 'm': actuator (actuation is disabled)"},
        Silent{
            "DisabledContact",
            R"(<option><flag contact="disable"/></option><worldbody><geom name="floor" type="plane" size="0 0 1"/>)"
            R"(<body><freejoint/>)" BALL,
            "geom 'floor' and 1 more: visual (contacts are disabled)"},
        Silent{"Sleep", R"(<option><flag sleep="enable"/></option><worldbody><body><freejoint/>)" BALL,
               "option: sleep"}),
    [](const auto& row) { return std::string(row.param.name); });

// Coordinates that run against those of the scene's joint: a target of -0 stood in the scenario, which was refused for it.
TEST(MjcfJoints, WithOppositeAxesAreNoServos) {
  REQUIRE_IMPORT("xml");
  for (const char* what : {R"(armature=".1")", R"(frictionloss=".1")", R"(range="-20 90")"}) {
    const Outcome outcome =
        import_mjcf(std::string(R"(<worldbody><body><joint type="slide" axis="1 0 0"/>)") +
                    "<joint axis=\"-1 0 0\" " + what + "/>" BALL);
    ASSERT_EQ(outcome.refusal, "") << what;
    const core::JointAngle& angle = outcome.scene().joints.at(0).angles.at(0);
    for (const double x : {angle.start, angle.force, angle.target, angle.target_amplitude})
      EXPECT_FALSE(std::signbit(x)) << what;
  }
}

// -k q - c q' + f along a joint.
struct Acting {
  const char *name, *text;
  double force, stiffness, damping;
};
class MjcfActuator : public testing::TestWithParam<Acting> {};

TEST_P(MjcfActuator, ActsAsInMuJoCo) {
  REQUIRE_IMPORT("xml");
  const Outcome outcome = import_mjcf(GetParam().text);
  ASSERT_EQ(outcome.refusal, "");
  const core::Joint& joint = outcome.scene().joints.at(0);
  const auto sum = [&](auto number) {
    double all = 0;
    for (const auto& angle : joint.angles) all += number(angle);
    return all;
  };
  EXPECT_EQ(sum([](const auto& c) { return c.force; }), GetParam().force);
  EXPECT_EQ(sum([](const auto& c) { return c.stiffness; }), GetParam().stiffness);
  EXPECT_EQ(sum([](const auto& c) { return c.damping; }), GetParam().damping);
}

INSTANTIATE_TEST_SUITE_P(
    Rules, MjcfActuator,
    testing::Values(
        Acting{"ControlIsClamped",
               HINGE
               R"(<actuator><motor joint="j" gear="5" ctrlrange="0.5 1" ctrllimited="true"/></actuator>)",
               2.5, 0, 0},
        Acting{"ControlIsNotClampedWithoutClampctrl",
               R"(<option><flag clampctrl="disable"/></option>)" HINGE
               R"(<actuator><motor joint="j" gear="5" ctrlrange="0.5 1" ctrllimited="true"/></actuator>)",
               0, 0, 0},
        Acting{"GroupIsDisabled",
               R"(<option actuatorgroupdisable="2"/>)" HINGE
               R"(<actuator><position joint="j" kp="50" group="2"/></actuator>)",
               0, 0, 0},
        Acting{"OtherGroupIsNotDisabled",
               R"(<option actuatorgroupdisable="1"/>)" HINGE
               R"(<actuator><position joint="j" kp="50" group="2"/></actuator>)",
               0, 50, 0},
        Acting{"DamperActsThroughTheGear",
               HINGE R"(<actuator><motor joint="j" gear="2" damping="3"/></actuator>)", 0, 0, 12},
        Acting{"DamperActsWithoutActuation",
               R"(<option><flag actuation="disable"/></option>)" HINGE
               R"(<actuator><motor joint="j" gear="2" damping="3"/></actuator>)",
               0, 0, 12},
        Acting{"DamperIsADamper",
               R"(<option><flag damper="disable"/></option>)" HINGE
               R"(<actuator><motor joint="j" gear="2" damping="3"/></actuator>)",
               0, 0, 0}),
    [](const auto& row) { return std::string(row.param.name); });

// o_friction takes the place of all frictions, where the flag is on.
TEST(MjcfOverride, GivesTheFrictionOfAllContacts) {
  REQUIRE_IMPORT("xml");
  for (const bool on : {true, false}) {
    const Outcome outcome = import_mjcf(
        std::string(R"(<option o_friction="0.2 0.2 0.005 0.0001 0.0001"><flag override=")") +
        (on ? "enable" : "disable") +
        R"("/></option><worldbody><geom type="plane" size="0 0 1" friction="0.9"/><body pos="0 0 .2"><freejoint/>)"
        R"(<geom type="box" size=".1 .1 .1" friction="0.7"/></body></worldbody>)");
    ASSERT_EQ(outcome.refusal, "");
    EXPECT_EQ(core::material_of(outcome.scene(), {.body = 0, .plane = 0})->friction, on ? 0.2 : 0.9);
  }
}

// Gravity of a body that a gravcomp of 1 holds is 0, and not -0; MuJoCo skips it with springs and dampers off.
TEST(MjcfGravcomp, IsSkippedWithThePassiveForces) {
  REQUIRE_IMPORT("xml");
  const std::string body = R"(<worldbody><body name="a" gravcomp="1"><freejoint/>)" BALL;
  const Outcome on = import_mjcf(body),
                off = import_mjcf(R"(<option><flag spring="disable" damper="disable"/></option>)" + body);
  ASSERT_TRUE(on.scene().bodies[0].gravity);
  for (const double g : *on.scene().bodies[0].gravity) {
    EXPECT_EQ(g, 0);
    EXPECT_FALSE(std::signbit(g));
  }
  EXPECT_FALSE(off.scene().bodies[0].gravity);
}

// actuatorgravcomp leaves the compensation to the actuators: without any there is none.
TEST(MjcfGravcomp, OfAnActuatorNeedsOne) {
  REQUIRE_IMPORT("xml");
  const std::string joint = R"(name="j" type="slide" axis="0 0 1" actuatorgravcomp="true")";
  const auto model = [](const std::string& joints, const std::string& more) {
    return R"(<worldbody><body name="a" gravcomp="0.5"><joint )" + joints + "/>" BALL + more;
  };
  const std::string motor = R"(<actuator><motor joint="j"/></actuator>)";
  EXPECT_FALSE(import_mjcf(model(joint, "")).scene().bodies[0].gravity);
  EXPECT_TRUE(import_mjcf(model(joint, motor)).scene().bodies[0].gravity);
  EXPECT_FALSE(import_mjcf(R"(<option><flag actuation="disable"/></option>)" + model(joint, motor))
                   .scene()
                   .bodies[0]
                   .gravity);
  const Outcome some = import_mjcf(model(joint + R"(/><joint type="slide" axis="1 0 0")", ""));
  EXPECT_TRUE(some.refuses("body 'a': actuator_force (gravity is compensated along some")) << some.refusal;
}

// Limits and dry friction are constraints: without these a ball joint has none.
TEST(MjcfBall, HasNoLimitWithoutConstraints) {
  REQUIRE_IMPORT("xml");
  const std::string body =
      R"(<worldbody><body><joint name="j" type="ball" range="0 30" limited="true" frictionloss="2"/>)" BALL;
  EXPECT_EQ(import_mjcf(R"(<option><flag constraint="disable"/></option>)" + body).refusal, "");
  const Outcome on = import_mjcf(body);
  EXPECT_TRUE(on.refuses("joint 'j': joint_limit (a ball joint)")) << on.refusal;
  EXPECT_TRUE(on.refuses("joint 'j': joint_friction (a ball joint)")) << on.refusal;
}

// MuJoCo lets the bodies of an equality touch, and those of a joint where filterparent is off.
TEST(MjcfJoinedContact, IsTold) {
  REQUIRE_IMPORT("xml");
  const std::string loop = R"(<worldbody><body name="a"><freejoint/><geom type="box" size=".1 .1 .1"/></body>
    <body name="b" pos="0.25 0 0"><freejoint/><geom type="box" size=".1 .1 .1" MASK/></body></worldbody>
    <equality><connect name="c" body1="a" body2="b" anchor="0.125 0 0"/></equality>)";
  const std::string tree = R"(<worldbody><body name="a"><freejoint/><geom type="box" size=".1 .1 .1"/>
    <body name="b" pos="0.25 0 0"><joint name="c" axis="0 1 0"/><geom type="box" size=".1 .1 .1" MASK/></body>
    </body></worldbody>)";
  const std::string off = R"(<option><flag filterparent="disable"/></option>)";
  const auto masked = [](std::string text, const std::string& mask) {
    return text.replace(text.find("MASK"), 4, mask);
  };
  const std::string apart = R"(contype="2" conaffinity="2")";
  struct Row {
    std::string text;
    bool told;
  };
  for (const Row& row : {Row{masked(loop, ""), true},
                         {masked(loop, apart), false},
                         {off + masked(tree, ""), true},
                         {off + masked(tree, apart), false},
                         {masked(tree, ""), false}}) {
    const Outcome outcome = import_mjcf(row.text);
    EXPECT_EQ(outcome.refusal, "");
    EXPECT_EQ(outcome.leaves_out("'c': joined_contact"), row.told) << row.text << outcome.left_out;
  }
}

// A folder with the reader of MuJoCo 2.2.2 alone, where it is built.
class OldMujoco : public testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path program = std::filesystem::path(binary_dir) / "cylon-import-mjcf";
    if (!std::filesystem::exists(program)) GTEST_SKIP() << "no libmujoco-dev";
    std::filesystem::create_symlink(program, folder_.path() / program.filename());
  }
  Outcome import_mjcf(const std::string& text) const {
    return import_text("<mujoco>" + text + "</mujoco>", "xml", {}, folder_.path());
  }

  const TemporaryFolder folder_;
};
using MjcfCollision = OldMujoco;
using MjcfWarning = OldMujoco;

// It was ignored: the ball rested on the plane, through which it falls.
TEST_F(MjcfCollision, PredefinedLeavesThePairsOfMasksOut) {
  const std::string scene =
      R"(<worldbody><geom name="floor" type="plane" size="1 1 1"/>)"
      R"(<body pos="0 0 1"><freejoint/><geom name="ball" size=".1" mass="1"/></body></worldbody>)";
  const Outcome all = import_mjcf(scene), none = import_mjcf(R"(<option collision="predefined"/>)" + scene);
  ASSERT_EQ(all.refusal + none.refusal, "");
  EXPECT_TRUE(all.scene().bodies.at(0).collide);
  EXPECT_EQ(all.scene().planes.size(), 1u);
  EXPECT_FALSE(none.scene().bodies.at(0).collide);
  EXPECT_TRUE(none.scene().planes.empty());
  EXPECT_TRUE(none.leaves_out("geom 'floor' and 1 more: visual")) << none.left_out;
}

TEST_F(MjcfCollision, DynamicLeavesThePairsOfTheFileOut) {
  const std::string scene =
      R"(<worldbody><geom name="floor" type="plane" size="1 1 1"/>)"
      R"(<body pos="0 0 1"><freejoint/><geom name="ball" size=".1" mass="1"/></body></worldbody>)"
      R"(<contact><pair name="p" geom1="floor" geom2="ball" friction="2 2 0 0 0"/></contact>)";
  EXPECT_TRUE(import_mjcf(scene).refuses("pair 'p': contact_pair"));
  const Outcome dynamic = import_mjcf(R"(<option collision="dynamic"/>)" + scene);
  ASSERT_EQ(dynamic.refusal, "");
  EXPECT_EQ(core::material_of(dynamic.scene(), {.body = 0, .plane = 0})->friction, 1);
}

// What MuJoCo warns of was lost where the model compiles.
TEST_F(MjcfWarning, OfNanInAnIncludedFileIsRefused) {
  std::ofstream(folder_.path() / "part.xml")
      << R"(<mujoco><body name="a" pos="nan 0 0"><joint/><geom size=".1"/></body></mujoco>)";
  const std::string beside = "../" + folder_.path().filename().string() + "/part.xml";
  const Outcome outcome = import_mjcf("<worldbody><include file='" + beside + "'/></worldbody>");
  EXPECT_TRUE(outcome.refuses("unread (XML contains a 'NaN'")) << outcome.refusal << outcome.left_out;
}

// The element was not named: a null of JSON was.
TEST(MjcfNotFinite, NamesTheElement) {
  REQUIRE_IMPORT("xml");
  const Outcome outcome = import_mjcf(
      R"(<worldbody><body name="a" pos="1e308 0 0"><joint/><geom size=".1" mass="1e308"/></body></worldbody>)");
  EXPECT_TRUE(outcome.refuses("body 'a': body_inertia is not finite")) << outcome.refusal;
  const Outcome nan = import_mjcf(R"(<worldbody><body name="a" pos="nan 0 0"><joint/>)" BALL);
  EXPECT_TRUE(nan.refuses(":1:20: body 'a': pos=\"nan 0 0\": NaN is no number")) << nan.refusal;
}

// A line of a text that nobody has was named, and no joint.
TEST(MjcfStart, OutsideOfTheLimitsNamesTheJoint) {
  REQUIRE_IMPORT("xml");
  const Outcome outcome =
      import_mjcf(R"(<worldbody><body><joint name="j" axis="0 1 0" range="10 30" limited="true"/>)" BALL);
  EXPECT_TRUE(outcome.refuses("joint 'j': it starts at 0, outside of its limits 0.17453")) << outcome.refusal;
}

// A joint of a scene stands for up to three of MJCF, and has one name.
TEST(MjcfName, OfAFurtherJointOfABodyIsTold) {
  REQUIRE_IMPORT("xml");
  const Outcome outcome = import_mjcf(
      R"(<worldbody><body><joint name="j" axis="0 1 0"/><joint name="second" axis="1 0 0"/>)" BALL);
  ASSERT_EQ(outcome.refusal, "");
  EXPECT_EQ(outcome.scene().joints.at(0).name, "j");
  EXPECT_TRUE(outcome.leaves_out("joint 'second': name (a motion of joint 'j')")) << outcome.left_out;
}

// It became a ball, though only two rates are free at the start.
TEST(MjcfHinges, OfWhichTheThirdIsAlongTheFirstAreNoBall) {
  REQUIRE_IMPORT("xml");
  const Outcome outcome = import_mjcf(
      R"(<worldbody><body><joint name="j" axis="0 0 1"/><joint axis="1 0 0"/><joint axis="0 0 1"/>)" BALL);
  EXPECT_TRUE(outcome.refuses("joint 'j': joint_kind (turn turn turn)")) << outcome.refusal;
}

// Its bodies may turn against each other about the point that it holds: it was refused.
TEST(MjcfWeld, WithoutTorqueIsABall) {
  REQUIRE_IMPORT("xml");
  const Outcome outcome = import_mjcf(
      R"(<worldbody><body name="a"><freejoint/><geom size=".1" mass="1"/></body>)"
      R"(<body name="b" pos="1 0 0"><freejoint/><geom size=".1" mass="1"/></body></worldbody>)"
      R"(<equality><weld name="w" body1="a" body2="b" anchor="0 0.2 0" torquescale="0"/></equality>)");
  ASSERT_EQ(outcome.refusal, "");
  const core::Joint& joint = outcome.scene().joints.at(0);
  EXPECT_EQ(joint.type, core::JointType::ball);
  EXPECT_LT((joint.point - core::Vector3(1, 0, -0.2)).norm(), 1e-15);  // y up
}

// MuJoCo 3 closes loops at sites too: it was refused.
TEST(MjcfEquality, OfSitesJoinsTheirBodies) {
  REQUIRE_IMPORT("xml");
  const Outcome outcome = import_mjcf(
      R"(<worldbody><body name="a"><freejoint/><geom size=".1" mass="1"/><site name="s" pos="0.4 0.1 0"/></body>)"
      R"(<body name="b" pos="1 0 0"><freejoint/><geom size=".1" mass="1"/><site name="t" pos="-0.6 0.1 0"/>)"
      R"(<site name="r" pos="-0.6 0.2 0"/></body></worldbody>)"
      R"(<equality><connect name="w" site1="s" site2="t"/><weld name="v" site1="t" site2="s"/></equality>)");
  if (outcome.refusal.find("site1") != std::string::npos) GTEST_SKIP() << "not of MuJoCo 2.2.2";
  ASSERT_EQ(outcome.refusal, "");
  ASSERT_EQ(outcome.scene().joints.size(), 2u);
  EXPECT_EQ(outcome.scene().joints[0].type, core::JointType::ball);
  EXPECT_LT((outcome.scene().joints[0].point - core::Vector3(0.4, 0, -0.1)).norm(), 1e-15);
  EXPECT_EQ(outcome.scene().joints[1].type, core::JointType::fixed);
}

// Hinges of one body whose axes meet beside their anchors, and such as do not.
TEST(MjcfHinges, MeetWhereTheirAxesDo) {
  REQUIRE_IMPORT("xml");
  const Outcome meeting = import_mjcf(
      R"(<worldbody><body><joint axis="0 1 0" pos="0.1 0.3 0"/><joint axis="1 0 0" pos="0.5 0.2 0"/>)" BALL);
  ASSERT_EQ(meeting.refusal, "");
  EXPECT_EQ(meeting.scene().joints.at(0).type, core::JointType::universal);
  EXPECT_LT((meeting.scene().joints[0].point - core::Vector3(0.1, 0, -0.2)).norm(), 1e-15);
  const Outcome apart = import_mjcf(
      R"(<worldbody><body><joint axis="0 1 0" pos="0.1 0.3 0.2"/><joint axis="1 0 0" pos="0.5 0.2 0.05"/>)" BALL);
  ASSERT_EQ(apart.refusal, "");
  const core::Joint& joint = apart.scene().joints.at(0);
  EXPECT_EQ(joint.type, core::JointType::offset_universal);
  EXPECT_NEAR(joint.length, 0.15, 1e-15);
  EXPECT_LT((joint.point - core::Vector3(0.1, 0.2, -0.2)).norm(), 1e-15);
  EXPECT_LT((core::held_point_of_body(joint) - core::Vector3(0.1, 0.05, -0.2)).norm(), 1e-15);
}

// A scene has no body that is called "world": an export refused it.
TEST(MjcfWorldbody, WithASurfaceIsCalledGround) {
  REQUIRE_IMPORT("xml");
  const Outcome outcome = import_mjcf(
      R"(<worldbody><geom type="box" size="1 1 .1"/><body name="a" pos="0 0 1"><freejoint/>)" BALL);
  EXPECT_TRUE(
      outcome.scene().bodies.at(static_cast<std::size_t>(number_of(outcome.scene(), "ground"))).locked);
  EXPECT_FALSE(outcome.leaves_out("name (")) << outcome.left_out;
}

}  // namespace
}  // namespace cylon::imports
