// Parts of URDF that changed the motion without a word: each is told or refused.
#include "tests/harness/imports/inline_model.h"

namespace cylon::imports {
namespace {

constexpr const char* inertia = R"(<inertia ixx="1" iyy="1.2" izz="1.4" ixy="0" ixz="0" iyz="0"/>)";

std::string link(const std::string& name, const std::string& mass = "1", const std::string& more = "") {
  return "<link name='" + name + "'><inertial><mass value='" + mass + "'/>" + inertia + "</inertial>" + more +
         "</link>\n";
}
std::string joint(const std::string& type, const std::string& more = "") {
  return "<joint name='j' type='" + type + "'><parent link='base'/><child link='l'/>" + more + "</joint>\n";
}
Outcome import_urdf(const std::string& text) {
  return import_text("<robot name='r'>\n" + text + "</robot>", "urdf");
}

struct Silent {
  const char* name;
  std::string text, says;
  bool refused;
};
class UrdfSilent : public testing::TestWithParam<Silent> {};

TEST_P(UrdfSilent, LossIsTold) {
  REQUIRE_IMPORT("urdf");
  const Outcome outcome = import_urdf(GetParam().text);
  EXPECT_TRUE(GetParam().refused ? outcome.refuses(GetParam().says) : outcome.leaves_out(GetParam().says))
      << outcome.refusal << '\n'
      << outcome.left_out;
}

const std::string two = link("base") + link("l", "2");
const std::string hinge = two + joint("continuous");

INSTANTIATE_TEST_SUITE_P(
    Elements, UrdfSilent,
    testing::Values(
        // urdfdom left the inertia out and went on.
        Silent{"MassWithAComma", link("base") + link("l", "1,5") + joint("fixed"),
               "mass [1,5] is not a float", true},
        Silent{"MassOfNan", link("base") + link("l", "nan") + joint("fixed"), "mass [nan] is not a float",
               true},
        Silent{"MassTooLarge", link("base") + link("l", "1e400") + joint("fixed"),
               "mass [1e400] is not a float", true},
        Silent{"FloatingMimic", two + joint("floating", "<mimic joint='j'/>"), "joint 'j': mimic", true},
        Silent{"FloatingDamping", two + joint("floating", "<dynamics damping='2'/>"),
               "joint 'j': joint_damping (a floating joint)", true},
        Silent{"FloatingFriction", two + joint("floating", "<dynamics friction='2'/>"),
               "joint 'j': joint_friction (a floating joint)", true},
        Silent{"ContinuousEffort", two + joint("continuous", "<limit effort='10' velocity='0'/>"),
               "joint 'j': effort", false},
        Silent{"ContinuousSpeed", two + joint("continuous", "<limit effort='0' velocity='3'/>"),
               "joint 'j': effort", false},
        Silent{"ContinuousLimit",
               two + joint("continuous", "<limit lower='-1' upper='1' effort='0' velocity='0'/>"),
               "joint 'j': unused (limits of a continuous joint)", false},
        Silent{"PlanarLimit", two + joint("planar", "<limit lower='-1' upper='1' effort='0' velocity='0'/>"),
               "joint 'j': unused (limits of a planar joint)", false},
        Silent{"PlanarEffort", two + joint("planar", "<limit effort='3' velocity='3'/>"), "joint 'j': effort",
               false},
        Silent{"FloatingLimit",
               two + joint("floating", "<limit lower='-1' upper='1' effort='0' velocity='0'/>"),
               "joint 'j': unused (limits of a floating joint)", false},
        Silent{"FloatingEffort", two + joint("floating", "<limit effort='3' velocity='3'/>"),
               "joint 'j': effort", false},
        Silent{"FixedLimit", two + joint("fixed", "<limit lower='-1' upper='1' effort='0' velocity='0'/>"),
               "joint 'j': unused (limits of a fixed joint)", false},
        Silent{"FixedDamping", two + joint("fixed", "<dynamics damping='2'/>"),
               "joint 'j': unused (dynamics of a fixed joint)", false},
        Silent{"FixedAxis", two + joint("fixed", "<axis xyz='0 1 0'/>"),
               "urdf:4: <axis>: unused (<axis> of joint 'j')", false},
        Silent{"SpringOfDynamics", two + joint("continuous", "<dynamics damping='1' stiffness='3'/>"),
               "urdf:4: <dynamics>: custom (attribute 'stiffness' of joint 'j')", false},
        Silent{"AttributeOfALink", "<link name='base' magic='3'/>", "link 'base': custom (attribute 'magic')",
               false},
        Silent{"AttributeOfAMass",
               "<link name='base'><inertial><mass value='1' unit='g'/>" + std::string(inertia) +
                   "</inertial></link>",
               "<mass>: custom (attribute 'unit' of <inertial>)", false},
        Silent{"ElementOfACollision",
               link("base", "1", "<collision><geometry><sphere radius='1'/></geometry><magic/></collision>"),
               "<magic>: custom (<magic> of <collision>)", false},
        // "No root link found" named no joint.
        Silent{
            "LinkOnItself",
            link("base") + "<joint name='k' type='fixed'><parent link='base'/><child link='base'/></joint>",
            "line 3: joint 'k': link 'base' hangs on itself", true},
        Silent{"Loop",
               two + joint("continuous") +
                   "<joint name='k' type='continuous'><parent link='l'/><child link='base'/></joint>",
               "line 5: joint 'k': link 'base' hangs on itself, through link 'l'", true},
        // The link was imported twice, and the first joint was lost.
        Silent{"TwoParents",
               two + link("m", "3") + joint("continuous") +
                   "<joint name='k' type='fixed'><parent link='m'/><child link='l'/></joint>",
               "joint 'k': link 'l' is the child of joint 'j' already", true},
        Silent{"Transmission", hinge + "<transmission name='t'><type>simple</type></transmission>",
               "urdf:5: transmission 't': transmission", false},
        Silent{"Unknown", hinge + "<bogus/>", "urdf:5: <bogus>: custom (<bogus>)", false},
        Silent{"UnknownInALink", link("base", "1", "<bogus/>"), "<bogus>: custom (<bogus> of link 'base')",
               false},
        Silent{"UnknownInAJoint", two + joint("continuous", "<bogus/>"),
               "<bogus>: custom (<bogus> of joint 'j')", false},
        Silent{"GazeboFriction", hinge + "<gazebo reference='l'><mu1>0.2</mu1></gazebo>",
               "<mu1>: custom (<mu1> of gazebo of 'l')", false},
        Silent{"GazeboSpring", hinge + "<gazebo reference='j'><springStiffness>4</springStiffness></gazebo>",
               "<springStiffness>: unread (<springStiffness> of gazebo of 'j')", true},
        Silent{"GazeboPlugin", hinge + "<gazebo><plugin name='p' filename='libwind.so'/></gazebo>",
               "plugin 'p': plugin_force", true},
        // Elements that Gazebo copies into the model passed as unknown.
        Silent{"GazeboJoint", hinge + "<gazebo><joint name='k' type='fixed'/></gazebo>",
               "joint 'k': unread (<joint> of <gazebo>)", true},
        Silent{"GazeboKinematic", hinge + "<gazebo reference='l'><kinematic>1</kinematic></gazebo>",
               "<kinematic>: unread (<kinematic> of gazebo of 'l')", true},
        Silent{"GazeboDrag", hinge + "<gazebo reference='l'><velocity_decay/></gazebo>",
               "<velocity_decay>: unread (<velocity_decay> of gazebo of 'l')", true},
        // A drive or a coupling of joints by a plugin passed as harmless.
        Silent{"GazeboMimicPlugin",
               hinge +
                   "<gazebo><plugin name='label' filename='libroboticsgroup_gazebo_mimic_joint_plugin.so'/>"
                   "</gazebo>",
               "plugin 'label': plugin_force", true},
        // It sets the positions of joints in each step, without a command those of the start.
        Silent{"RosControl",
               hinge + "<gazebo><plugin name='c' filename='libgazebo_ros_control.so'/></gazebo>",
               "plugin 'c': plugin_force", true},
        Silent{"Quaternion", two + joint("continuous", "<origin xyz='0 0 1' quat_xyzw='1 0 0 0'/>"),
               "<origin>: unread (attribute 'quat_xyzw' of joint 'j')", true},
        // Such a hinge does not turn.
        Silent{"NoBounds", two + joint("revolute", "<limit effort='3' velocity='3'/>"),
               "<limit>: assumed (lower = 0 of joint 'j')", false},
        Silent{"NoUpperBound", two + joint("prismatic", "<limit lower='-1' effort='3' velocity='3'/>"),
               "<limit>: assumed (upper = 0 of joint 'j')", false},
        Silent{"GazeboOtherPlugin",
               hinge + "<gazebo><plugin name='p' filename='libgazebo_ros_imu.so'/></gazebo>",
               "plugin 'p': plugin", false},
        // It passed by a part of its name.
        Silent{"GazeboUnknownPlugin", hinge + "<gazebo><plugin name='p' filename='libimu.so'/></gazebo>",
               "plugin 'p': plugin_force", true},
        // What is in a sensor was not looked at.
        Silent{"PluginOfASensor",
               hinge + "<gazebo reference='l'><sensor name='s' type='contact'><plugin name='p' "
                       "filename='libPush.so'/></sensor></gazebo>",
               "plugin 'p': plugin_force", true},
        // A part of a robot in a wrong place, or that a macro would make, was left out as unknown.
        Silent{"MassOfALink", link("base", "1", "<mass value='5'/>"),
               "<mass>: unread (<mass> of link 'base')", true},
        Silent{"DampingOfAJoint", two + joint("continuous", "<damping value='5'/>"),
               "<damping>: unread (<damping> of joint 'j')", true},
        Silent{"OriginOfALink", link("base", "1", "<origin xyz='0 0 1'/>"),
               "<origin>: unread (<origin> of link 'base')", true},
        // What is below a limit or dynamics was not looked at.
        Silent{"BelowDynamics", two + joint("continuous", "<dynamics damping='1'><spring k='3'/></dynamics>"),
               "<spring>: custom (<spring> of <dynamics>)", false},
        Silent{"Macro", hinge + "<xacro:arm xmlns:xacro='http://ros.org/wiki/xacro' parent='l'/>",
               "<xacro:arm>: unread (<xacro:arm>)", true}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(UrdfPlain, LosesOnlyWhatTheFormatDoesNotSay) {
  REQUIRE_IMPORT("urdf");
  const Outcome outcome = import_urdf(two + joint("continuous", "<axis xyz='0 0 1'/><origin xyz='0 0 1'/>"));
  ASSERT_EQ(outcome.refusal, "");
  EXPECT_EQ(outcome.left_out.find('\n'), outcome.left_out.size() - 1) << outcome.left_out;
  EXPECT_TRUE(outcome.leaves_out("robot 'r': assumed"));
}

}  // namespace
}  // namespace cylon::imports
