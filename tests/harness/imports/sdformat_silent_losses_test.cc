// Parts of SDFormat that changed the motion without a word: each is read, told or refused.
#include "tests/harness/imports/inline_model.h"

#include "harness/core/collision_filter.h"
#include "harness/imports/losses.h"

#include <cstdlib>
#include <set>
#include <utility>

namespace cylon::imports {
namespace {

constexpr const char* half_pi = "1.5707963267948966";

Outcome import_model(const std::string& text, const std::string& attributes = "") {
  return import_text("<sdf version='1.9'>\n<model name='m' " + attributes + ">\n" + text + "</model></sdf>",
                     "sdf");
}
Outcome import_world(const std::string& text) {
  return import_text("<sdf version='1.9'>\n<world name='w'>\n" + text + "</world></sdf>", "sdf");
}

std::string link(const std::string& name, const std::string& more = "", double z = 1) {
  return "<link name='" + name + "'><pose>0 0 " + std::to_string(z) +
         " 0 0 0</pose><inertial><mass>2</mass></inertial>" + more + "</link>\n";
}
std::string ball(const std::string& contact = "") {
  return "<collision name='c'><geometry><sphere><radius>.1</radius></sphere></geometry><surface><contact>" +
         contact + "</contact></surface></collision>";
}

std::string surface(const std::string& what) {
  return "<collision name='c'><geometry><sphere><radius>.1</radius></sphere></geometry><surface>" + what +
         "</surface></collision>";
}

// A model that is the root of its file ignored placement_frame; in a world it did not.
TEST(SdfRootModel, StandsByItsPlacementFrame) {
  REQUIRE_IMPORT("sdf");
  const std::string model = std::string("<model name='m' placement_frame='f'><pose>0.3 0 0 0 0 0</pose>") +
                            "<frame name='f'><pose>0 0.2 0 " + half_pi + " 0 0</pose></frame>" + link("l") +
                            "</model>";
  const Outcome alone = import_text("<sdf version='1.9'>" + model + "</sdf>", "sdf"),
                within = import_world(model);
  ASSERT_EQ(alone.refusal, "");
  ASSERT_EQ(within.refusal, "");
  const core::BodyState &a = alone.scene().bodies.at(0).initial, &b = within.scene().bodies.at(0).initial;
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.orientation.coeffs(), b.orientation.coeffs());
  EXPECT_GT((a.position - core::Vector3(0.3, 1, 0)).norm(), 0.1);  // where it stands by its own frame
}

// It was the world's z.
TEST(SdfJoint, WithoutAnAxisTurnsAboutZOfItsOwnFrame) {
  REQUIRE_IMPORT("sdf");
  const Outcome outcome =
      import_model(std::string("<link name='a'><pose>0 0 1 ") + half_pi +
                   " 0 0</pose><inertial><mass>1</mass></inertial></link>"
                   "<joint name='j' type='revolute'><parent>world</parent><child>a</child></joint>");
  ASSERT_EQ(outcome.refusal, "");
  // z of a frame that is rolled by a right angle is -y, which is z here.
  EXPECT_LT((outcome.scene().joints.at(0).axis - core::Vector3(0, 0, 1)).norm(), 1e-15);
}

struct Silent {
  const char* name;
  std::string text;  // of a world
  const char* says;
  bool refused;
};
class SdfSilent : public testing::TestWithParam<Silent> {};

TEST_P(SdfSilent, LossIsTold) {
  REQUIRE_IMPORT("sdf");
  const Outcome outcome = import_world(GetParam().text);
  EXPECT_TRUE(GetParam().refused ? outcome.refuses(GetParam().says) : outcome.leaves_out(GetParam().says))
      << outcome.refusal << '\n'
      << outcome.left_out;
}

std::string model(const std::string& text) { return "<model name='m'>\n" + text + "</model>"; }
std::string hinge(const std::string& axis, const std::string& more = "") {
  return model(link("a") + "<joint name='j' type='revolute'><parent>world</parent><child>a</child><axis>" +
               "<xyz>0 0 1</xyz>" + axis + "</axis>" + more + "</joint>");
}
std::string joint(const std::string& type, const std::string& axes) {
  return model(link("a") + "<joint name='j' type='" + type + "'><parent>world</parent><child>a</child>" +
               axes + "</joint>");
}
const std::string wind = "<wind><linear_velocity>10 0 0</linear_velocity></wind>";

INSTANTIATE_TEST_SUITE_P(
    Elements, SdfSilent,
    testing::Values(
        Silent{"WindOnALink", wind + model(link("a", "<enable_wind>true</enable_wind>")),
               "sdf:4: <enable_wind> of link 'a': wind", true},
        Silent{"WindOnAModel", wind + model("<enable_wind>true</enable_wind>" + link("a")),
               "sdf:4: <enable_wind> of model 'm': wind", true},
        Silent{"State", model(link("a")) + "<state world_name='w'></state>",
               "sdf:5: <state> of world 'w': keyframe", false},
        Silent{"Mimic", hinge("<mimic joint='k'><multiplier>2</multiplier></mimic>"),
               "<mimic> of axis: mimic", true},
        Silent{"AddedMass",
               model("<link name='a'><inertial><mass>1</mass><fluid_added_mass><xx>3</xx></fluid_added_mass>"
                     "</inertial></link>"),
               "<fluid_added_mass> of inertial: fluid", true},
        Silent{"Motor", hinge("", "<physics><ode><max_force>3</max_force></ode></physics>"),
               "<max_force> of ode: actuator_force", true},
        Silent{"Solver", hinge("", "<physics><ode><cfm_damping>1</cfm_damping></ode></physics>"),
               "<cfm_damping> of ode: solver", false},
        Silent{"Unknown", model("<magic>3</magic>" + link("a")), "sdf:3: <magic> of model 'm': custom",
               false},
        Silent{"UnknownInAnAxis", hinge("<dynamics><frction>3</frction></dynamics>"),
               "<frction> of dynamics: custom", false},
        Silent{"Comma", hinge("<dynamics><damping>0,5</damping></dynamics>"),
               "line 5: <damping>: '0,5' is no number", true},
        Silent{"CommaInAVector", model("<pose>0 0 1,5 0 0 0</pose>" + link("a")),
               "<pose>: '1,5' is no number", true},
        Silent{"Speed", hinge("<limit><velocity>3</velocity></limit>"), "joint 'm::j': effort (velocity)",
               false},
        Silent{"BallDamping",
               joint("ball", "<axis><xyz>1 0 0</xyz><dynamics><damping>3</damping></dynamics></axis>"),
               "joint 'm::j': joint_damping (a ball joint)", true},
        Silent{"BallFriction",
               joint("ball", "<axis><xyz>1 0 0</xyz><dynamics><friction>3</friction></dynamics></axis>"),
               "joint 'm::j': joint_friction (a ball joint)", true},
        Silent{
            "BallSpring",
            joint("ball",
                  "<axis><xyz>1 0 0</xyz><dynamics><spring_stiffness>3</spring_stiffness></dynamics></axis>"),
            "joint 'm::j': joint_spring (a ball joint)", true},
        Silent{"BallLimit", joint("ball", "<axis><xyz>1 0 0</xyz><limit><lower>-1</lower></limit></axis>"),
               "joint 'm::j': joint_limit (a ball joint)", true},
        Silent{"BallAxis", joint("ball", "<axis><xyz>1 0 0</xyz></axis>"), "joint 'm::j': unused (<axis>)",
               false},
        Silent{"SecondAxis",
               hinge("", "<axis2><xyz>0 1 0</xyz><dynamics><damping>3</damping></dynamics></axis2>"),
               "joint 'm::j': unused (<axis2>)", false},
        Silent{"FixedAxis",
               joint("fixed", "<axis><xyz>1 0 0</xyz><dynamics><damping>3</damping></dynamics></axis>"),
               "joint 'm::j': unused (<axis>)", false},
        Silent{"ContinuousLimit",
               joint("continuous",
                     "<axis><xyz>1 0 0</xyz><limit><lower>-1</lower><upper>1</upper></limit></axis>"),
               "joint 'm::j': unused (limits of a continuous joint)", false},
        // The link had 1 kg and an inertia of 1 kg m^2.
        Silent{"InertiaOfShapes", model("<link name='a'><inertial auto='true'/>" + ball() + "</link>"),
               "sdf:4: attribute 'auto' of <inertial>: unread", true},
        Silent{"InertiaNotOfShapes", model("<link name='a'><inertial auto='false'/></link>"),
               "sdf:4: attribute 'auto' of <inertial>: custom", false},
        Silent{"UnknownAttribute", model("<link name='a' magic='3'/>"),
               "sdf:4: attribute 'magic' of <link>: custom", false},
        // It was left out as unknown, and the body fell.
        Silent{"JointOfAWorld",
               model(link("a")) +
                   "<joint name='j' type='revolute'><parent>world</parent><child>m::a</child></joint>",
               "<joint> of world 'w': unread (<joint>)", true},
        Silent{"LinkOfAWorld", model(link("a")) + link("b"), "<link> of world 'w': unread (<link>)", true},
        Silent{"DampingOfAJoint", hinge("", "<damping>3</damping>"),
               "<damping> of joint 'j': unread (<damping>)", true},
        // A velocity that the plugin states, or holds at zero.
        Silent{"VelocityControl",
               model(link("a") + "<plugin filename='gz-sim-velocity-control-system' name='imu'/>"),
               "plugin 'imu': plugin_force", true},
        Silent{"Wheels", model(link("a") + "<plugin filename='gz-sim' name='gz::sim::systems::DiffDrive'/>"),
               "plugin 'gz::sim::systems::DiffDrive': plugin_force", true},
        Silent{"Broadcaster",
               model(link("a") + "<plugin filename='gz-sim' name='gz::sim::systems::SceneBroadcaster'/>"),
               "plugin 'gz::sim::systems::SceneBroadcaster': plugin", false},
        // These were known to the library, had no row, and vanished.
        Silent{"BulletFriction",
               model(link("a", surface("<friction><bullet><friction>.3</friction></bullet></friction>"))),
               "collision 'm::a::c': other_engine (<bullet> friction)", false},
        Silent{"BulletSecondFriction",
               model(link("a", surface("<friction><ode><mu>.3</mu></ode><bullet><friction>.3</friction>"
                                       "<friction2>.4</friction2></bullet></friction>"))),
               "collision 'm::a::c': other_engine (<bullet> friction2)", false},
        Silent{"RollingFriction",
               model(link(
                   "a",
                   surface("<friction><bullet><rolling_friction>.1</rolling_friction></bullet></friction>"))),
               "<rolling_friction> of bullet: other_engine", false},
        Silent{"FrictionDirection",
               model(link("a", surface("<friction><ode><fdir1>1 0 0</fdir1></ode></friction>"))),
               "<fdir1> of ode: soft_surface", false},
        Silent{"BounceThreshold", model(link("a", surface("<bounce><threshold>.01</threshold></bounce>"))),
               "<threshold> of bounce: other_engine", false},
        Silent{"PoissonsRatio", model(link("a", ball("<poissons_ratio>.4</poissons_ratio>"))),
               "<poissons_ratio> of contact: soft_surface", false},
        Silent{"ElasticModulus", model(link("a", ball("<elastic_modulus>1e8</elastic_modulus>"))),
               "<elastic_modulus> of contact: soft_surface", false},
        Silent{"LimitBounce", hinge("", "<physics><ode><bounce>.5</bounce></ode></physics>"),
               "<bounce> of ode: other_engine", false},
        Silent{"MotorSpeed", hinge("", "<physics><ode><velocity>3</velocity></ode></physics>"),
               "<velocity> of ode: other_engine", false},
        Silent{"Suspension",
               hinge("", "<physics><ode><suspension><cfm>.1</cfm></suspension></ode></physics>"),
               "<cfm> of suspension: other_engine", false},
        Silent{"LimitErp", hinge("", "<physics><ode><limit><erp>.5</erp></limit></ode></physics>"),
               "<erp> of limit: solver", false},
        Silent{"AutoDisable", model("<allow_auto_disable>true</allow_auto_disable>" + link("a")),
               "<allow_auto_disable> of model 'm': sleep", false},
        Silent{"ThreadPitch", hinge("", "<thread_pitch>3</thread_pitch>"),
               "<thread_pitch> of joint 'j': unused", false},
        Silent{"Gui", "<gui><camera name='c'/></gui>" + model(link("a")), "<gui> of world 'w': presentation",
               false},
        Silent{"Scene", "<scene><grid>false</grid></scene>" + model(link("a")),
               "<scene> of world 'w': presentation", false},
        Silent{"MagneticField", "<magnetic_field>0 1 0</magnetic_field>" + model(link("a")),
               "<magnetic_field> of world 'w': sensor", false},
        Silent{"SecondPhysics",
               "<physics name='p' type='ode'/><physics name='q' "
               "type='ode'><max_step_size>.1</max_step_size></physics>" +
                   model(link("a")),
               "physics 'q': solver (not the profile of the start)", false},
        Silent{"EngineOfPhysics", "<physics name='p' type='simbody'/>" + model(link("a")),
               "attribute 'type' of <physics>: solver", false},
        // A shape of a newer release was unknown, and the link had no surface.
        Silent{
            "Cone",
            model(link(
                "a", "<collision name='c'><geometry><cone><radius>1</radius></cone></geometry></collision>")),
            "<cone> of geometry: shape", true},
        Silent{"UnknownShape",
               model(link("a", "<collision name='c'><geometry><torus/></geometry></collision>")),
               "<torus> of geometry: unread", true},
        // They are in the server, where they can push.
        Silent{
            "PluginOfASensor",
            model(link("a",
                       "<sensor name='s' type='contact'><plugin name='p' filename='libPush.so'/></sensor>")),
            "plugin 'p': plugin_force", true},
        Silent{"PluginOfAVisual",
               model(link("a",
                          "<visual name='v'><geometry><sphere><radius>1</radius></sphere></geometry>"
                          "<plugin name='p' filename='libPush.so'/></visual>")),
               "plugin 'p': plugin_force", true},
        // Their names held "range", "contact", "label" and "camera".
        Silent{"ArrangeForces", model(link("a") + "<plugin filename='libArrangeForces.so' name='p'/>"),
               "plugin 'p': plugin_force", true},
        Silent{"ContactForce", model(link("a") + "<plugin filename='libContactForcePlugin.so' name='p'/>"),
               "plugin 'p': plugin_force", true},
        Silent{"ClassOfOthers", model(link("a") + "<plugin filename='gz-sim' name='other::systems::Label'/>"),
               "plugin 'other::systems::Label': plugin_force", true},
        Silent{"SystemOfOthers",
               model(link("a") + "<plugin filename='libgz-sim-camera-push-system.so' name='p'/>"),
               "plugin 'p': plugin_force", true},
        Silent{"LibraryOfARelease",
               model(link("a") + "<plugin filename='libignition-gazebo6-imu-system.so' name='p'/>"),
               "plugin 'p': plugin", false},
        Silent{"LibraryOfClassic", model(link("a") + "<plugin filename='libImuSensorPlugin.so' name='p'/>"),
               "plugin 'p': plugin", false},
        Silent{"CategoryBits", model(link("a", ball("<category_bitmask>2</category_bitmask>"))),
               "<category_bitmask> of contact: unread", true}),
    [](const auto& row) { return std::string(row.param.name); });

// Every element and attribute that the library knows is read, told or lost by a row, so that a newer release brings no
// silent one; and a row that names no element is a mistake.
TEST(SdfElements, OfTheLibraryAllHaveARow) {
  REQUIRE_IMPORT("sdf");
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "elements").string();
  const std::string program = (std::filesystem::path(binary_dir) / format_of("m.sdf")->program).string();
  ASSERT_EQ(std::system(("'" + program + "' --elements > '" + file + "'").c_str()), 0);
  std::ifstream in(file);
  std::size_t lines = 0;
  std::set<std::string> said;
  for (std::string line; std::getline(in, line); ++lines) {
    EXPECT_FALSE(line.ends_with(": no row") || line.ends_with(": no element")) << line;
    if (const std::size_t lost = line.find(": lost "); lost != std::string::npos) {
      EXPECT_NO_THROW(loss_kind(line.substr(lost + 7))) << line;
    }
    said.insert(line);
  }
  EXPECT_GT(lines, 150u);
  for (const char* line : {"surface/friction/ode/mu: read", "link/visual: told",
                           "surface/friction/bullet/rolling_friction: lost other_engine",
                           "model@canonical_link: read", "world/physics@type: lost solver"})
    EXPECT_TRUE(said.contains(line)) << line;
}

// Of a file with both the world alone was read.
TEST(SdfRoot, WithAModelBesideAWorldIsRefused) {
  REQUIRE_IMPORT("sdf");
  const Outcome outcome =
      import_text("<sdf version='1.9'>\n<world name='w'>" + model(link("a")) + "</world>\n" +
                      "<model name='beside'>" + link("b") + "</model></sdf>",
                  "sdf");
  EXPECT_TRUE(outcome.refuses("model 'beside': unread (beside a world)")) << outcome.refusal;
}

// The library reads five elements of <include> and drops the others.
TEST(SdfInclude, TellsWhatTheLibraryDropsOfIt) {
  REQUIRE_IMPORT("sdf");
  const TemporaryFolder folder;
  const std::string part = (folder.path() / "part.sdf").string();
  std::ofstream(part) << "<sdf version='1.9'>" + model(link("a")) + "</sdf>";
  const std::string include = "<include><uri>file://" + part + "</uri><name>n</name><pose>0 0 1 0 0 0</pose>";
  const Outcome known = import_world(include + "</include>"),
                unknown = import_world(include + "<self_collide>1</self_collide></include>"),
                moving = import_world(include + "<gravity>0</gravity></include>");
  EXPECT_EQ(known.refusal + known.left_out, "");
  EXPECT_TRUE(unknown.leaves_out("<self_collide> of include: custom")) << unknown.left_out << unknown.refusal;
  EXPECT_TRUE(moving.refuses("<gravity> of include: unread")) << moving.refusal;
}

// What a file states as it is without it is no loss, and neither is what a scene does.
TEST(SdfElements, StatedAsTheyAreWithoutItAreNoLoss) {
  REQUIRE_IMPORT("sdf");
  const Outcome outcome = import_text(
      "<sdf version='1.9'><world name='w'><physics name='p' "
      "type='ignored'><real_time_factor>1.00</real_time_factor>"
      "<max_contacts>20</max_contacts></physics>" +
          model("<allow_auto_disable>false</allow_auto_disable>" +
                link("a",
                     surface("<bounce><threshold>100000.0</threshold></bounce><friction><ode><mu>.3</mu>"
                             "<fdir1>0 0 0</fdir1></ode><bullet><friction>.3</friction></bullet></friction>"
                             "<contact><poissons_ratio>0.30</poissons_ratio></contact>"))) +
          "</world></sdf>",
      "sdf", {.strict = true});
  EXPECT_EQ(outcome.refusal, "");
}

// DART, the engine of gz-sim, reads the friction of <ode>; that of <bullet> was taken.
TEST(SdfFriction, IsThatOfOdeAsDartReadsIt) {
  REQUIRE_IMPORT("sdf");
  const std::string floor =
      "<model name='n'><static>1</static><link name='f'><collision name='c'><geometry><plane/>"
      "</geometry></collision></link></model>";
  const std::string bullet = "<bullet><friction>.2</friction></bullet>";
  for (const auto& [friction, says] :
       {std::pair<std::string, double>{bullet, 1}, {"<ode><mu>.4</mu></ode>" + bullet, .4}}) {
    const std::string stated = std::string("<friction>").append(friction).append("</friction>");
    const Outcome outcome = import_world(floor + model(link("a", surface(stated))));
    ASSERT_EQ(outcome.refusal, "");
    EXPECT_EQ(core::material_of(outcome.scene(), {.body = 0, .plane = 0})->friction, says);
  }
}

// Without wind, and without an enabled body, nothing is lost.
TEST(SdfWind, IsNoLossWhereItMovesNothing) {
  REQUIRE_IMPORT("sdf");
  EXPECT_EQ(import_world(model(link("a", "<enable_wind>true</enable_wind>"))).refusal, "");
  EXPECT_EQ(import_world(wind + model(link("a", "<enable_wind>false</enable_wind>"))).refusal, "");
}

int number_of(const core::Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].name == name) return static_cast<int>(i);
  ADD_FAILURE() << "no body " << name;
  return 0;
}

// Links of a model touch where one of them has self_collide.
TEST(SdfSelfCollide, OfALinkCounts) {
  REQUIRE_IMPORT("sdf");
  const Outcome outcome = import_world(model(link("a", "<self_collide>true</self_collide>" + ball()) +
                                             link("b", ball(), 2) + link("c", ball(), 3)));
  ASSERT_EQ(outcome.refusal, "");
  const core::Scene& scene = outcome.scene();
  const int a = number_of(scene, "m::a"), b = number_of(scene, "m::b"), c = number_of(scene, "m::c");
  const core::ContactRules rules(scene);
  EXPECT_TRUE(rules.bodies(a, b));
  EXPECT_TRUE(rules.bodies(a, c));
  EXPECT_FALSE(rules.bodies(b, c));
}

// No force acts on such a surface; a bitmask overrides that.
TEST(SdfCollideWithoutContact, TouchesNothing) {
  REQUIRE_IMPORT("sdf");
  for (const bool overridden : {false, true}) {
    const std::string contact = std::string("<collide_without_contact>true</collide_without_contact>") +
                                (overridden ? "<collide_bitmask>255</collide_bitmask>" : "");
    const Outcome outcome = import_world("<model name='m'>" + link("a", ball(contact)) +
                                         "</model><model name='n'>" + link("b", ball(), 2) + "</model>");
    ASSERT_EQ(outcome.refusal, "");
    const core::Scene& scene = outcome.scene();
    const core::ContactRules rules(scene);
    EXPECT_EQ(scene.bodies.at(0).collide && scene.bodies.at(1).collide && rules.bodies(0, 1), overridden);
    EXPECT_TRUE(outcome.leaves_out("collide_without_contact")) << outcome.left_out;
  }
}

// Vertices of Collada files with z up were turned to y up.
TEST(SdfMesh, OfColladaHasTheCoordinatesOfItsFile) {
  REQUIRE_IMPORT("sdf");
  for (const char* up : {"X_UP", "Y_UP", "Z_UP"}) {
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "tetrahedron.dae").string();
    std::ofstream(file) << R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="half" meter="0.5"/><up_axis>)"
                        << up << R"(</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="12">0 0 0 1 0 0 0 2 0 0 0 3</float_array><technique_common>
<accessor source="#a" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
    const Outcome outcome = import_world(
        "<model name='b'><pose>9 0 9 0 0 0</pose>" + link("l", ball(), 0) + "</model>" +
        "<model name='t'><static>1</static><link name='l'><collision name='c'><geometry><mesh><uri>" + file +
        "</uri></mesh></geometry></collision></link></model>");
    ASSERT_EQ(outcome.refusal, "") << up;
    const core::Scene& scene = outcome.scene();
    core::Vector3 most = core::Vector3::Zero();
    for (const core::Body& body : scene.bodies)
      if (const auto* mesh = std::get_if<core::Mesh>(&body.shape))
        for (const core::Vector3& v : mesh->vertices)
          most = most.cwiseMax(body.initial.position + body.initial.orientation * v);
    // x, y, z of the file are x, -z, y of the scene, in halves of a metre.
    EXPECT_NEAR(most.x(), 0.5, 1e-6) << up;
    EXPECT_NEAR(most.y(), 1.5, 1e-6) << up;
  }
}

}  // namespace
}  // namespace cylon::imports
