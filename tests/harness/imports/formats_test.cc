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

#include <fmt/format.h>
#include <fmt/ranges.h>
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

// What the library of a format says of a file, in the axes of the file.
struct SaidBody {
  std::string name;
  double mass = 0;
  Vector3 centre = Vector3::Zero();
  foreign::Matrix3 inertia = foreign::Matrix3::Zero();  // about the centre, world axes
};
struct SaidJoint {
  std::string body;
  std::vector<std::string> kinds;  // of its motions, from the other end to `body`: turn, slide, ball
  std::vector<Vector3> axes;       // of each, world axes
  std::vector<Vector3> anchors;    // a point on each axis of a turn, or the point of a ball; of a slide any
};
struct Said {
  std::vector<SaidBody> bodies;  // that move
  std::vector<SaidJoint> joints;
  Vector3 gravity;
  double step = 0;
};

// Of SDFormat and URDF: what the program of the format prints, after the bodies that are one are one.
Said said_by_program(const nlohmann::json& json, const std::string& file) {
  foreign::Model model = foreign::from_json(json);
  merge_fixed(model, file);  // frames without mass belong to what they are fixed to
  Said said{{}, {}, model.gravity, model.step};
  for (const foreign::Body& body : model.bodies) {
    if (body.locked) continue;
    const foreign::Matrix3 r = body.pose.turn.toRotationMatrix();
    said.bodies.push_back({body.name, body.mass, body.pose.position, r * body.inertia * r.transpose()});
  }
  for (const foreign::Joint& joint : model.joints) {
    SaidJoint& made = said.joints.emplace_back();
    made.body = model.bodies[static_cast<std::size_t>(joint.body)].name;
    for (const foreign::Freedom& f : joint.freedoms) {
      made.kinds.push_back(f.kind), made.axes.push_back(f.axis);
      made.anchors.push_back(joint.point);
    }
  }
  return said;
}

// Of MJCF: the arrays that MuJoCo compiled, read here anew and not by harness/imports/mjcf, which is what is tested.
class Arrays {
 public:
  explicit Arrays(const nlohmann::json& json) : json_(json) {}

  int integer(const char* array, int i) const { return arrays().at(array).at(at(i)).get<int>(); }
  double number(const char* array, int i) const { return arrays().at(array).at(at(i)).get<double>(); }
  Vector3 vector(const char* array, int i) const { return vector_of(arrays().at(array), 3 * i); }
  Vector3 start(const char* array, int i) const { return vector_of(json_.at("start").at(array), 3 * i); }
  foreign::Matrix3 turn(const char* array, int i) const { return matrix(arrays().at(array), i); }
  foreign::Matrix3 start_turn(const char* array, int i) const {
    return matrix(json_.at("start").at(array), i);
  }
  int size(const char* name) const { return json_.at("sizes").at(name).get<int>(); }
  std::string body(int i) const { return json_.at("names").at("body").at(at(i)).get<std::string>(); }
  /// First numbers of the data of an equality.
  Vector3 equality(int i) const {
    const nlohmann::json& data = arrays().at("eq_data");
    return vector_of(data, i * static_cast<int>(data.size()) / size("neq"));
  }
  const nlohmann::json& option(const char* name) const { return json_.at("option").at(name); }
  static Vector3 vector_of(const nlohmann::json& list, int i) {
    return {list.at(at(i)).get<double>(), list.at(at(i + 1)).get<double>(), list.at(at(i + 2)).get<double>()};
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  // The matrix of a quaternion w, x, y, z.
  static foreign::Matrix3 matrix(const nlohmann::json& list, int i) {
    const Vector3 v = vector_of(list, 4 * i + 1);
    return foreign::Quaternion(list.at(at(4 * i)).get<double>(), v.x(), v.y(), v.z()).toRotationMatrix();
  }
  const nlohmann::json& arrays() const { return json_.at("arrays"); }

  const nlohmann::json& json_;
};

//   m = sum m_i,   c = sum m_i x_i / m,   I = sum R_i diag(I_i) R_i^T + m_i (|d|^2 1 - d d^T),   d = x_i - c,
// with x_i = xipos and R_i = ximat, of the bodies that MuJoCo welds to one.
SaidBody whole_of(const Arrays& m, int root) {
  SaidBody whole{.name = m.body(root)};
  std::vector<int> parts;
  for (int i = 1; i < m.size("nbody"); ++i)
    if (m.integer("body_weldid", i) == root) parts.push_back(i);
  for (const int i : parts) {
    whole.mass += m.number("body_mass", i);
    whole.centre += m.number("body_mass", i) * m.start("xipos", i);
  }
  whole.centre /= whole.mass;
  for (const int i : parts) {
    const foreign::Matrix3 r = m.start_turn("xquat", i) * m.turn("body_iquat", i);
    const Vector3 d = m.start("xipos", i) - whole.centre;
    whole.inertia +=
        r * m.vector("body_inertia", i).asDiagonal() * r.transpose() +
        m.number("body_mass", i) * (d.squaredNorm() * foreign::Matrix3::Identity() - d * d.transpose());
  }
  return whole;
}

Said said_by_mujoco(const nlohmann::json& json) {
  const Arrays m(json);
  Said said{{}, {}, Arrays::vector_of(m.option("gravity"), 0), m.option("timestep").get<double>()};
  const char* const kinds[] = {"free", "ball", "slide", "turn"};  // mjtJoint
  for (int body = 1; body < m.size("nbody"); ++body) {
    if (m.integer("body_weldid", body) != body) continue;
    said.bodies.push_back(whole_of(m, body));
    SaidJoint joint{.body = m.body(body), .kinds = {}, .axes = {}, .anchors = {}};
    const int first = m.integer("body_jntadr", body);
    for (int j = first; j < first + m.integer("body_jntnum", body); ++j) {
      joint.kinds.emplace_back(kinds[m.integer("jnt_type", j)]);
      joint.axes.push_back(m.start("xaxis", j)), joint.anchors.push_back(m.start("xanchor", j));
    }
    if (joint.kinds != std::vector<std::string>{"free"}) said.joints.push_back(joint);
  }
  for (int i = 0; i < m.size("neq"); ++i) {  // the files here have connections alone
    const int body = m.integer("eq_obj1id", i);
    said.joints.push_back({m.body(body),
                           {"ball"},
                           {Vector3::Zero()},
                           {m.start("xpos", body) + m.start_turn("xquat", body) * m.equality(i)}});
  }
  return said;
}

// The joint of a scene that leaves the motions, and of which of them its axes are; -1: none of them.
struct Expected {
  std::string_view motions;
  core::JointType type;
  int axis = -1, axis_2 = -1;
};
const Expected& expected(const SaidJoint& said, bool apart) {
  using enum core::JointType;
  static const Expected rows[] = {{"", fixed},
                                  {"ball", ball},
                                  {"turn", hinge, 0},
                                  {"slide", slider, 0},
                                  {"slide turn", cylindrical, 0},
                                  {"turn turn", universal, 0, 1},
                                  {"slide slide", rectangular, -1, 0},
                                  {"slide slide turn", planar, 2, 0},
                                  {"turn turn turn", gimbal, 0, 2}};
  static const Expected offset = {"turn turn", offset_universal, 0, 1};
  if (apart) return offset;
  return *std::ranges::find(rows, fmt::format("{}", fmt::join(said.kinds, " ")), &Expected::motions);
}

// Whether the axes of two turns do not meet.
bool are_apart(const SaidJoint& said) {
  if (said.kinds != std::vector<std::string>{"turn", "turn"}) return false;
  const Vector3 across = said.axes[0].cross(said.axes[1]);
  return std::abs(across.dot(said.anchors[1] - said.anchors[0])) > 1e-9 * across.norm();
}

// The point of a joint lies on the axes of its turns; of two that do not meet the second is `length` along axis x axis_2.
void check_point(const core::Joint& mine, const SaidJoint& said) {
  Vector3 point = mine.point;
  bool is_second = false;
  for (std::size_t k = 0; k < said.kinds.size(); ++k) {
    if (said.kinds[k] == "ball") {
      EXPECT_LT((point - up(said.anchors[k])).norm(), 1e-14) << said.body;
    }
    if (said.kinds[k] != "turn") continue;
    if (is_second && mine.length > 0) point += mine.length * mine.axis.cross(*mine.axis_2);
    EXPECT_LT((point - up(said.anchors[k])).cross(up(said.axes[k])).norm(), 1e-14) << said.body << " " << k;
    is_second = true;
  }
}

void check_joint(const core::Joint& mine, const SaidJoint& said, const core::Scene& scene) {
  EXPECT_EQ(scene.bodies.at(static_cast<std::size_t>(mine.body)).name, said.body);
  const Expected& row = expected(said, are_apart(said));
  EXPECT_EQ(mine.type, row.type) << said.body;
  const auto axis = [&](int k) { return up(said.axes.at(static_cast<std::size_t>(k))); };
  if (row.axis >= 0) {
    EXPECT_LT((mine.axis - axis(row.axis)).norm(), 1e-15) << said.body;
  }
  ASSERT_EQ(mine.axis_2.has_value(), row.axis_2 >= 0) << said.body;
  if (row.axis_2 >= 0) {
    EXPECT_LT((*mine.axis_2 - axis(row.axis_2)).norm(), 1e-15) << said.body;
  }
  if (row.type == core::JointType::rectangular) {
    EXPECT_LT((mine.axis - axis(0).cross(axis(1))).norm(), 1e-15) << said.body;
  }
  check_point(mine, said);
}

class ReadBack : public testing::TestWithParam<const char*> {};

// Masses, centres, world inertias and both axes of joints of the library against those of the file that is written and read.
TEST_P(ReadBack, GivesTheNumbersOfTheLibrary) {
  const fs::path file = data(GetParam());
  REQUIRE_LIBRARY(file);
  const nlohmann::json json = read_by(*format_of(file), file, {}, programs);
  const Said said =
      format_of(file)->name == "MJCF" ? said_by_mujoco(json) : said_by_program(json, file.string());
  const scenario::Scenario read = scenario::parse(import_file(file, {}, programs).toml, "imported.toml");
  std::map<std::string, const core::Body*> bodies;
  for (const core::Body& body : read.scene.bodies) bodies[body.name] = &body;
  for (const SaidBody& body : said.bodies) {
    ASSERT_TRUE(bodies.contains(body.name)) << body.name;
    const core::Body& mine = *bodies.at(body.name);
    EXPECT_NEAR(mine.mass, body.mass, 1e-15 * body.mass) << body.name;
    EXPECT_LT((mine.initial.position - up(body.centre)).norm(), 1e-15 * (1 + body.centre.norm()));
    // v . I v of any direction is the same.
    const core::Matrix3 world = core::world_inertia(mine, mine.initial.orientation);
    for (const Vector3& v : {Vector3(1, 0.2, -0.3), Vector3(-0.4, 1, 0.6), Vector3(0.1, -0.5, 1)})
      EXPECT_NEAR(up(v).dot(world * up(v)), v.dot(body.inertia * v), 1e-13 * body.inertia.norm())
          << body.name;
  }
  EXPECT_GT(said.bodies.size(), 0u);
  ASSERT_EQ(read.scene.joints.size(), said.joints.size());
  for (std::size_t i = 0; i < said.joints.size(); ++i)
    check_joint(read.scene.joints[i], said.joints[i], read.scene);
  EXPECT_DOUBLE_EQ(read.step, said.step);
  EXPECT_LT((core::gravity(read.scene) - up(said.gravity)).norm(), 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Files, ReadBack,
                         testing::Values("arm.xml", "loop.xml", "masks.xml", "joints.xml", "world.sdf",
                                         "joints.sdf", "arm.urdf", "joints.urdf"));

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
      text.insert(0, "<body pos='0 0 1'><joint axis='1 0 0'/><geom type='sphere' size='.1'/>")
          .append("</body>");
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
