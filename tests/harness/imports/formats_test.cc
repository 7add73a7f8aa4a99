// Files of each format, read by its library: the numbers of the scene are those of the library.
#include "harness/core/collision_filter.h"
#include "harness/core/input_error.h"
#include "harness/imports/imports.h"
#include "harness/imports/mjcf/mjcf.h"
#include "harness/imports/model/model_json.h"
#include "harness/imports/program.h"
#include "harness/imports/steps.h"
#include "harness/scenario/scenario.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

namespace cylon::imports {
namespace {

namespace fs = std::filesystem;
using foreign::Vector3;

const fs::path programs = binary_dir;

fs::path data(const std::string& name) { return fs::path(source_dir) / "tests/data/imports" / name; }

// Whether the library of the file's format is here; a test is left out otherwise.
bool readable(const fs::path& file) { return fs::exists(program_of(*format_of(file), programs)); }

#define REQUIRE_LIBRARY(file) \
  if (!readable(file))        \
  GTEST_SKIP() << format_of(file)->program << " is not built: " << format_of(file)->package

foreign::Model said_of(const fs::path& file) {
  const nlohmann::json json = read_by(*format_of(file), file, {}, programs);
  return format_of(file)->name == "MJCF" ? model_of_mjcf(Compiled(json)) : foreign::from_json(json);
}

std::string refusal(const fs::path& file, const Options& options = {}) {
  try {
    import_file(file, options, programs);
    return "none";
  } catch (const core::InputError& error) {
    return error.what();
  }
}

// z up to y up.
Vector3 up(const Vector3& v) { return {v.x(), v.z(), -v.y()}; }

class ReadBack : public testing::TestWithParam<const char*> {};

// Masses, centres, world inertias and joint axes of the library against those of the file that is written and read.
TEST_P(ReadBack, GivesTheNumbersOfTheLibrary) {
  const fs::path file = data(GetParam());
  REQUIRE_LIBRARY(file);
  foreign::Model said = said_of(file);
  merge_fixed(said, file.string());  // frames without mass belong to what they are fixed to
  const scenario::Scenario read = scenario::parse(import_file(file, {}, programs).toml, "imported.toml");
  std::map<std::string, const core::Body*> bodies;
  for (const core::Body& body : read.scene.bodies) bodies[body.name] = &body;
  std::size_t moving = 0;
  for (const foreign::Body& body : said.bodies) {
    if (body.locked) continue;
    ++moving;
    ASSERT_TRUE(bodies.contains(body.name)) << body.name;
    const core::Body& mine = *bodies.at(body.name);
    EXPECT_DOUBLE_EQ(mine.mass, body.mass) << body.name;
    EXPECT_LT((mine.initial.position - up(body.pose.position)).norm(),
              1e-15 * (1 + body.pose.position.norm()));
    // v . I v of any direction is the same.
    const foreign::Matrix3 r = body.pose.turn.toRotationMatrix(), inertia = r * body.inertia * r.transpose();
    const core::Matrix3 world = core::world_inertia(mine, mine.initial.orientation);
    for (const Vector3& v : {Vector3(1, 0.2, -0.3), Vector3(-0.4, 1, 0.6), Vector3(0.1, -0.5, 1)})
      EXPECT_NEAR(up(v).dot(world * up(v)), v.dot(inertia * v), 1e-13 * inertia.norm()) << body.name;
  }
  EXPECT_GT(moving, 0u);
  ASSERT_EQ(read.scene.joints.size(), said.joints.size());
  for (std::size_t i = 0; i < said.joints.size(); ++i) {
    const core::Joint& mine = read.scene.joints[i];
    EXPECT_LT((mine.point - up(said.joints[i].point)).norm(), 1e-14);
    if (core::kind_of(mine.type).has_axis()) {
      EXPECT_LT((mine.axis - up(said.joints[i].freedoms.front().axis)).norm(), 1e-15);
    }
  }
  EXPECT_DOUBLE_EQ(read.step, said.step);
  EXPECT_LT((core::gravity(read.scene) - up(said.gravity)).norm(), 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Files, ReadBack,
                         testing::Values("arm.xml", "loop.xml", "masks.xml", "world.sdf", "arm.urdf"));

// The same, unturned.
TEST(KeptAxes, StayAsTheyAre) {
  const fs::path file = data("arm.urdf");
  REQUIRE_LIBRARY(file);
  foreign::Model said = said_of(file);
  merge_fixed(said, file.string());
  const auto read = scenario::parse(import_file(file, {.keep_axes = true}, programs).toml, "imported.toml");
  EXPECT_EQ(core::gravity(read.scene), Vector3(0, 0, -9.81));
  ASSERT_EQ(read.scene.bodies.size(), said.bodies.size());
  for (std::size_t i = 0; i < said.bodies.size(); ++i)
    EXPECT_LT((read.scene.bodies[i].initial.position - said.bodies[i].pose.position).norm(), 1e-15);
}

TEST(Arm, SaysWhatActsOnItsJoints) {
  const fs::path file = data("arm.xml");
  REQUIRE_LIBRARY(file);
  const auto read = scenario::parse(import_file(file, {}, programs).toml, "imported.toml");
  ASSERT_EQ(read.scene.joints.size(), 3u);
  const core::Joint &rail = read.scene.joints[0], &shoulder = read.scene.joints[1],
                    &cross = read.scene.joints[2];
  EXPECT_EQ(rail.type, core::JointType::slider);
  ASSERT_EQ(rail.displacements.size(), 1u);
  EXPECT_EQ(rail.displacements[0].stiffness, 30);
  EXPECT_EQ(rail.displacements[0].target, 0.05);
  EXPECT_EQ(rail.displacements[0].damping, 0.4);
  EXPECT_EQ(rail.displacements[0].lower, -1);
  EXPECT_EQ(rail.displacements[0].upper, 1.5);
  EXPECT_EQ(shoulder.type, core::JointType::hinge);
  ASSERT_EQ(shoulder.angles.size(), 1u);
  EXPECT_EQ(shoulder.angles[0].start, 0.2);
  EXPECT_EQ(shoulder.angles[0].stiffness, 4);  // the position servo at its control of 0
  EXPECT_EQ(shoulder.angles[0].target, 0);
  EXPECT_EQ(shoulder.angles[0].friction, 0.07);
  EXPECT_EQ(cross.type, core::JointType::universal);
  ASSERT_EQ(cross.angles.size(), 1u);
  EXPECT_EQ(cross.angles[0].which, core::Ordinal::second);
  EXPECT_EQ(cross.angles[0].damping, 0.02);
}

TEST(Masks, TouchAsMuJoCoSays) {
  const fs::path file = data("masks.xml");
  REQUIRE_LIBRARY(file);
  const auto read = scenario::parse(import_file(file, {}, programs).toml, "imported.toml");
  const core::Scene& scene = read.scene;
  std::map<std::string, int> number;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) number[scene.bodies[i].name] = static_cast<int>(i);
  const core::ContactRules rules(scene);
  struct Row {
    const char *a, *b;
    bool touch;
  };
  // type and affinity: a 2/0, b 2/2, c 0/2, d 2/2; b and d are excluded; the floor 1/6 touches who has a type of 2.
  for (const Row& row : {Row{"a", "b", true},
                         {"a", "c", true},
                         {"a", "d", true},
                         {"b", "c", true},
                         {"b", "d", false},
                         {"c", "d", true}})
    EXPECT_EQ(rules.bodies(number.at(row.a), number.at(row.b)), row.touch) << row.a << row.b;
  for (const auto& [name, touch] :
       std::map<std::string, bool>{{"a", true}, {"b", true}, {"c", false}, {"d", true}})
    EXPECT_EQ(rules.body_and_plane(number.at(name), 0), touch) << name;
  // The larger friction counts.
  EXPECT_EQ(core::material_of(scene, {.body = number.at("a"), .plane = 0})->friction, 0.9);
  EXPECT_EQ(core::material_of(scene, {.body = number.at("b"), .plane = 0})->friction, 0.5);
}

TEST(World, PairsFrictionAndRestitutionAsGazeboDoes) {
  const fs::path file = data("world.sdf");
  REQUIRE_LIBRARY(file);
  const auto read = scenario::parse(import_file(file, {}, programs).toml, "imported.toml");
  const core::Scene& scene = read.scene;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const auto material = core::material_of(scene, {.body = static_cast<int>(i), .plane = 0});
    if (scene.bodies[i].name == "box::link") {
      EXPECT_EQ(material->friction, 0.3);
    }
    if (scene.bodies[i].name == "ball::link") {
      EXPECT_EQ(material->friction, 0.8);
      EXPECT_EQ(material->restitution, 0.5 * 0.8);
    }
  }
}

struct Refusal {
  const char *file, *says;
};
class BadFiles : public testing::TestWithParam<Refusal> {};

TEST_P(BadFiles, AreRefusedNamingFileAndElement) {
  const fs::path file = data(GetParam().file);
  REQUIRE_LIBRARY(file);
  const std::string told = refusal(file);
  EXPECT_NE(told.find(GetParam().file), std::string::npos) << told;
  EXPECT_NE(told.find(GetParam().says), std::string::npos) << told;
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadFiles,
    testing::Values(Refusal{"no_inertia.urdf", "link 'hand': it moves, but its mass is 0 kg"},
                    Refusal{"limits.urdf", "joint 'wrist': its limits are 2 and -1"},
                    Refusal{"mesh.urdf",
                            "collision of link 'base': the file 'package://robot/base.stl' is not there"},
                    Refusal{"self.urdf", "urdf"}, Refusal{"self.sdf", "loop"},
                    Refusal{"lossy.xml", "joint 'axle': armature (0.3 of "},
                    Refusal{"lossy.xml", "geom 'egg': shape (ellipsoid that moves)"},
                    Refusal{"lossy.xml", "tendon 'rope': tendon_force"},
                    Refusal{"lossy.xml", "option: fluid (density 1.2"},
                    Refusal{"lossy.xml", "geom 'ball': torsional_friction (condim 4)"}));

// MuJoCo 2.2.2 tells the line of the <include>; 3.14 tells line 0, wherever it stands.
TEST(Bad, MjcfThatIncludesItselfIsRefusedAtTheLineThatTheLibraryTells) {
  const fs::path file = data("includes_itself.xml");
  REQUIRE_LIBRARY(file);
  const bool newer = program_of(*format_of(file), programs).filename() == format_of(file)->newer;
  const std::string told = refusal(file);
  EXPECT_NE(told.find(std::string("File '") + file.filename().string() +
                      "' already included Element 'include', line " + (newer ? "0" : "1")),
            std::string::npos)
      << told;
}

// libsdformat read such a file twice over and said nothing, or went on until its time was up.
TEST(Bad, SdfThatIncludesItselfIsRefusedWithTheWayRound) {
  const fs::path file = data("includes_itself.sdf"), back = data("includes_back.sdf");
  REQUIRE_LIBRARY(file);
  const std::string a = fs::canonical(file).string(), b = fs::canonical(back).string();
  EXPECT_NE(refusal(file).find("a file includes itself: " + a + " → " + b + " → " + a), std::string::npos)
      << refusal(file);
  EXPECT_NE(refusal(back).find("a file includes itself: " + b + " → " + a + " → " + b), std::string::npos)
      << refusal(back);
  const fs::path twice = data("includes_twice.sdf");  // one file, twice, is no circle
  EXPECT_EQ(scenario::parse(import_file(twice, {}, programs).toml, "imported.toml").scene.bodies.size(), 3u);
}

// A hinge on the world takes the rotor's inertia to its body, other joints to their coordinate, from which --leave-out takes it.
TEST(Armature, IsTheInertiaOfABodyOnTheWorldAndElsewhereOfACoordinate) {
  const fs::path file = data("rotors.xml");
  REQUIRE_LIBRARY(file);
  const auto read = scenario::parse(import_file(file, {}, programs).toml, "imported.toml");
  EXPECT_LT((read.scene.bodies.at(0).inertia - foreign::Matrix3(Vector3(0.7, 0.9, 0.8).asDiagonal())).norm(),
            1e-15);
  ASSERT_EQ(read.scene.joints.size(), 3u);
  EXPECT_TRUE(read.scene.joints[0].angles.empty());
  EXPECT_EQ(read.scene.joints[1].angles.at(0).armature, 0.001);
  EXPECT_EQ(read.scene.joints[2].angles.at(0).armature, 0.3);
  const Imported without = import_file(file, {.leave_out = {"armature"}}, programs);
  EXPECT_TRUE(std::ranges::any_of(without.left_out, [](const std::string& line) {
    return line.find("joint 'small': armature (0.001 of ") != std::string::npos;
  }));
  for (const core::Joint& joint : scenario::parse(without.toml, "imported.toml").scene.joints)
    EXPECT_TRUE(joint.angles.empty());
}

TEST(Tendon, WithALimitAloneIsLeftOut) {
  const fs::path file = data("rotors.xml");
  REQUIRE_LIBRARY(file);
  const Imported imported = import_file(file, {}, programs);
  EXPECT_TRUE(std::ranges::any_of(imported.left_out, [](const std::string& line) {
    return line.find("tendon 'strap': tendon_limit") != std::string::npos;
  }));
}

TEST(Pictures, ThatAreMissingAreLeftOut) {
  const fs::path file = data("picture.xml");
  REQUIRE_LIBRARY(file);
  if (program_of(*format_of(file), programs).filename() != format_of(file)->newer)
    GTEST_SKIP() << "MuJoCo 2.2.2 refuses a picture that is missing";
  const Imported imported = import_file(file, {}, programs);
  EXPECT_TRUE(std::ranges::any_of(imported.left_out, [](const std::string& line) {
    return line.find("picture 'nowhere.png': presentation") != std::string::npos;
  }));
}

// A root without mass is a base; the link that it carries moves.
TEST(Urdf, RootWithoutMassStaysWhereItIs) {
  const fs::path file = data("massless_root.urdf");
  REQUIRE_LIBRARY(file);
  const Imported imported = import_file(file, {}, programs);
  const auto read = scenario::parse(imported.toml, "imported.toml");
  ASSERT_EQ(read.scene.bodies.size(), 1u);
  ASSERT_EQ(read.scene.joints.size(), 1u);
  EXPECT_EQ(read.scene.joints[0].to, core::world);
  EXPECT_TRUE(std::ranges::any_of(imported.left_out, [](const std::string& line) {
    return line.find("link 'rail': assumed (a root without mass does not move)") != std::string::npos;
  }));
}

// A root without mass that a fixed joint ties to mass is a part of a body that moves.
TEST(Urdf, FootprintOfARobotMoves) {
  const fs::path file = data("footprint.urdf");
  REQUIRE_LIBRARY(file);
  const auto read = scenario::parse(import_file(file, {}, programs).toml, "imported.toml");
  ASSERT_EQ(read.scene.bodies.size(), 1u);
  EXPECT_FALSE(read.scene.bodies[0].locked);
}

TEST(Strict, RefusesWhatIsLeftOutOtherwise) {
  const fs::path file = data("world.sdf");
  REQUIRE_LIBRARY(file);
  EXPECT_EQ(refusal(file), "none");
  const std::string told = refusal(file, {.strict = true});
  EXPECT_NE(told.find("world.sdf:23: sensor 'imu': sensor"), std::string::npos) << told;
  EXPECT_NE(told.find("world.sdf:7: plugin 'gz::sim::systems::SceneBroadcaster': plugin"), std::string::npos)
      << told;
}

// They were ignored.
TEST(Options, OfAnotherFormatAreRefused) {
  const Options keyframe{.keyframe = "home"}, fixed{.fixed_base = true}, root{.roots = {"/tmp"}};
  struct Row {
    const char* file;
    Options options;
    const char* says;
  };
  for (const Row& row : {Row{"arm.urdf", keyframe, "--keyframe is for MJCF files, and this is URDF"},
                         {"world.sdf", keyframe, "--keyframe is for MJCF files, and this is SDFormat"},
                         {"arm.xml", fixed, "--fixed-base is for URDF files, and this is MJCF"},
                         {"world.sdf", fixed, "--fixed-base is for URDF files, and this is SDFormat"},
                         {"arm.xml", root, "--root is for SDFormat and URDF files, and this is MJCF"}})
    EXPECT_NE(refusal(data(row.file), row.options).find(row.says), std::string::npos) << row.says;
  const fs::path file = data("arm.urdf");
  REQUIRE_LIBRARY(file);
  EXPECT_EQ(refusal(file, {.fixed_base = true, .roots = {"/tmp"}}), "none");
}

TEST(Warnings, OfTheLibraryAreTold) {
  const fs::path file = data("arm.xml");
  REQUIRE_LIBRARY(file);
  nlohmann::json json = read_by(*format_of(file), file, {}, programs);
  json["warnings"] = {"the mass is large"};
  const foreign::Model model = model_of_mjcf(Compiled(json));
  EXPECT_TRUE(std::ranges::any_of(model.losses, [](const foreign::Loss& loss) {
    return loss.what == "warning" && loss.detail == "the mass is large";
  }));
}

// MuJoCo and libsdformat read a URDF in part: links, joints and couplings were gone without a word.
TEST(WrongEnding, IsRefusedByTheRootElement) {
  const TemporaryFolder folder;
  struct Row {
    const char *file, *text, *says;
  };
  for (const Row& row :
       {Row{"u.sdf", "<robot name='r'><link name='a'/></robot>",
            "u.sdf:1:1: <robot> is the root of a file of URDF, and this one's ending is that of SDFormat: "
            "name it .urdf"},
        {"u.world", "<?xml version='1.0'?>\n<robot name='r'/>", "u.world:2:1: <robot> is the root of a file"},
        {"u.xml", "<robot name='r'><link name='a'/></robot>", "ending is that of MJCF: name it .urdf"},
        {"m.urdf", "<mujoco><worldbody/></mujoco>", "<mujoco> is the root of a file of MJCF"},
        {"m.sdf", "<mujocoinclude/>", "<mujocoinclude> is the root of a file of MJCF"},
        {"s.xml", "<sdf version='1.9'/>", "<sdf> is the root of a file of SDFormat"},
        {"s.urdf", "<sdf version='1.9'/>", "ending is that of URDF: name it .sdf"}}) {
    const fs::path file = folder.path() / row.file;
    std::ofstream(file) << row.text;
    const std::string told = refusal(file);
    EXPECT_NE(told.find(row.says), std::string::npos) << told;
  }
}

TEST(LeaveOut, TakesARefusalForALoss) {
  const fs::path file = data("lossy.xml");
  REQUIRE_LIBRARY(file);
  Options options{.leave_out = {"armature", "tendon_force", "fluid", "torsional_friction", "shape"}};
  EXPECT_EQ(refusal(file, options), "none");
  options.leave_out.pop_back();
  EXPECT_EQ(refusal(file, options).find("armature"), std::string::npos);
  EXPECT_NE(refusal(file, options).find("shape"), std::string::npos);
}

// Deeper than any stack of a parser that recurses, and larger than a model may be: an error, no crash and no hang.
// From some 125 bodies on MuJoCo 3 in WebAssembly aborted, or went on with memory that its stack had overwritten.
TEST(Chain, IsAsDeepAsTheStackOfMujocoTakes) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "chain.xml";
  REQUIRE_LIBRARY(file);
  const auto chain = [&](int bodies) {
    std::ofstream text(file);
    text << "<mujoco><worldbody>";
    for (int i = 0; i < bodies; ++i)
      text << "<body pos='0 0 1'><joint axis='1 0 0'/><geom type='sphere' size='.1'/>";
    for (int i = 0; i < bodies; ++i) text << "</body>";
    text << "</worldbody></mujoco>";
  };
  chain(90);
  const Imported imported = import_file(file, {}, programs);
  EXPECT_EQ(scenario::parse(imported.toml, "chain.toml").scene.bodies.back().initial.position.y(), 90);
  chain(140);
  EXPECT_NE(refusal(file).find("an element nested more than 110 deep"), std::string::npos) << refusal(file);
}

// What a file includes is in no count of its own elements.
TEST(Chain, OfAnIncludedFileIsCounted) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "chain.xml";
  REQUIRE_LIBRARY(file);
  const auto nested = [](int bodies, const std::string& inside) {
    std::string text = inside;
    for (int i = 0; i < bodies; ++i)
      text = "<body pos='0 0 1'><joint axis='1 0 0'/><geom type='sphere' size='.1'/>" + text + "</body>";
    return text;
  };
  std::ofstream(folder.path() / "part.xml") << "<mujoco>" + nested(56, "") + "</mujoco>";
  std::ofstream(file) << "<mujoco><worldbody>" + nested(57, "<include file='part.xml'/>") +
                             "</worldbody></mujoco>";
  if (program_of(*format_of(file), programs).filename() != format_of(file)->newer)
    GTEST_SKIP() << "MuJoCo 2.2.2 has another stack";
  EXPECT_NE(refusal(file).find("113 bodies hang from each other"), std::string::npos) << refusal(file);
}

TEST(Hostile, FilesEndWithAnError) {
  const TemporaryFolder folder;
  const auto nested = [](const char* open, const char* close, int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += open;
    for (int i = 0; i < depth; ++i) text += close;
    return text;
  };
  const std::pair<const char*, std::string> files[] = {
      {"deep.xml", "<mujoco><worldbody>" + nested("<body>", "</body>", 20'000) + "</worldbody></mujoco>"},
      {"deep.urdf", nested("<robot>", "</robot>", 20'000)},
      {"deep.sdf", nested("<sdf version='1.9'>", "</sdf>", 20'000)},
      {"bytes.sdf", std::string("\0\xff<sdf", 6)},
  };
  for (const auto& [name, text] : files) {
    const fs::path file = folder.path() / name;
    std::ofstream(file) << text;
    if (readable(file)) {
      EXPECT_NE(refusal(file), "none") << name;
    }
  }
}

TEST(Missing, ProgramsSayWhatBringsThem) {
  try {
    import_file(data("arm.urdf"), {}, "/nowhere");
    FAIL();
  } catch (const core::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("`./run engines` brings it (liburdfdom-dev)"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace cylon::imports
