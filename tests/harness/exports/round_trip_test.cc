// A scene that is written in another format and imported again is the same scene, to rounding.
#include "harness/exports/exports.h"

#include "harness/core/collision_filter.h"
#include "harness/core/fields.h"
#include "harness/core/joint_coordinates.h"
#include "harness/core/solid.h"
#include "harness/core/surfaces.h"
#include "harness/imports/imports.h"
#include "harness/imports/program.h"
#include "tests/harness/exports/scenes.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

namespace cylon::exports {
namespace {

namespace fs = std::filesystem;
using core::Vector3;

// Of numbers of the size of 1: products of quaternions, and what a compiler makes of an inertia.
constexpr double rounding = 1e-13;

struct Case {
  const char *name, *toml, *ending;
  bool older = false;  // MuJoCo 2.2.2, whose compiler turns an inertia by iterations that stop early
};

class RoundTrip : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / (std::string(GetParam().name) + GetParam().ending);
    const imports::Format& format = *imports::format_of(file);
    fs::path programs = binary_dir;
    if (GetParam().older) {
      fs::create_symlink(programs / format.program, folder.path() / format.program);
      programs = folder.path();
    }
    if (!fs::exists(imports::program_of(format, programs)))
      GTEST_SKIP() << format.program << " is not built: " << format.package;
    before_ = scenario::parse(GetParam().toml, "before.toml");
    const Exported exported = export_scenario(before_, GetParam().toml, format.name);
    std::ofstream(file) << exported.xml;
    imports::Options options;
    if (!exported.notes.empty()) options.keyframe = "start";
    after_ = scenario::parse(imports::import_file(file, options, programs).toml, "after.toml");
    for (std::size_t i = 0; i < after_.scene.bodies.size(); ++i) {
      number_.emplace(after_.scene.bodies[i].name, static_cast<int>(i));
      number_.emplace(plain(after_.scene.bodies[i].name), static_cast<int>(i));
    }
  }

  // "scene::crank" and "box::link" of SDFormat are 'crank' and 'box'.
  static std::string plain(const std::string& name) {
    const std::size_t at = name.find("::");
    if (at == std::string::npos) return name;
    return name.substr(at + 2) == "link" ? name.substr(0, at) : name.substr(at + 2);
  }

  // The index afterwards of a body of the scene before.
  int now(int body) const {
    return body == core::world ? body : number_.at(before_.scene.bodies[static_cast<std::size_t>(body)].name);
  }
  const core::Body& body_now(int body) const {
    return after_.scene.bodies.at(static_cast<std::size_t>(now(body)));
  }

  scenario::Scenario before_, after_;
  std::map<std::string, int> number_;
};

TEST_P(RoundTrip, KeepsBodies) {
  ASSERT_EQ(after_.scene.bodies.size(), before_.scene.bodies.size());
  for (std::size_t i = 0; i < before_.scene.bodies.size(); ++i) {
    const core::Body &was = before_.scene.bodies[i], &is = body_now(static_cast<int>(i));
    SCOPED_TRACE(was.name);
    EXPECT_EQ(is.locked, was.locked);
    EXPECT_LT((is.initial.position - was.initial.position).norm(), rounding);
    EXPECT_LT(is.initial.orientation.angularDistance(was.initial.orientation), 1e-7);  // acos near 1
    EXPECT_LT((is.initial.orientation.toRotationMatrix() - was.initial.orientation.toRotationMatrix()).norm(),
              rounding);
    EXPECT_LT((is.initial.velocity - was.initial.velocity).norm(), rounding);
    EXPECT_LT((is.initial.angular_velocity - was.initial.angular_velocity).norm(), rounding);
    if (was.locked) continue;
    EXPECT_DOUBLE_EQ(is.mass, was.mass);
    EXPECT_LT((is.inertia - was.inertia).norm(), rounding);
    EXPECT_LT((core::gravity_of(after_.scene, is) - core::gravity_of(before_.scene, was)).norm(), rounding);
  }
}

void expect_same(const core::JointCoordinate& is, const core::JointCoordinate& was) {
  EXPECT_EQ(is.which, was.which);
  EXPECT_NEAR(is.start, was.start, rounding);
  EXPECT_EQ(is.lower.has_value(), was.lower.has_value());
  EXPECT_EQ(is.upper.has_value(), was.upper.has_value());
  EXPECT_NEAR(is.lower.value_or(0), was.lower.value_or(0), rounding);
  EXPECT_NEAR(is.upper.value_or(0), was.upper.value_or(0), rounding);
  EXPECT_NEAR(is.force, was.force, rounding);
  EXPECT_NEAR(is.stiffness, was.stiffness, rounding);
  EXPECT_NEAR(is.target, was.target, rounding);
  EXPECT_NEAR(is.damping, was.damping, rounding);
  EXPECT_NEAR(is.friction, was.friction, rounding);
  EXPECT_NEAR(is.armature, was.armature, rounding);
}

TEST_P(RoundTrip, KeepsJointsAndWhatActsAlongThem) {
  ASSERT_EQ(after_.scene.joints.size(), before_.scene.joints.size());
  for (const core::Joint& was : before_.scene.joints) {
    SCOPED_TRACE(before_.scene.bodies[static_cast<std::size_t>(was.body)].name);
    const auto found = std::ranges::find_if(after_.scene.joints, [&](const core::Joint& is) {
      return is.type == was.type && is.body == now(was.body) && is.to == now(was.to);
    });
    ASSERT_NE(found, after_.scene.joints.end());
    const core::Joint& is = *found;
    if (was.type != core::JointType::fixed) {  // which has no point
      EXPECT_LT((is.point - was.point).norm(), rounding);
    }
    if (core::kind_of(was.type).has_axis()) {
      EXPECT_LT((is.axis - was.axis).norm(), rounding);
    }
    if (core::kind_of(was.type).has_second_axis()) {
      EXPECT_LT((*is.axis_2 - *was.axis_2).norm(), rounding);
    }
    EXPECT_NEAR(is.length, was.length, rounding);
    ASSERT_EQ(is.displacements.size(), was.displacements.size());
    ASSERT_EQ(is.angles.size(), was.angles.size());
    for (std::size_t i = 0; i < was.displacements.size(); ++i)
      expect_same(is.displacements[i], was.displacements[i]);
    for (std::size_t i = 0; i < was.angles.size(); ++i) expect_same(is.angles[i], was.angles[i]);
  }
}

// Who touches whom, how, and with what surface: the support in some directions.
TEST_P(RoundTrip, KeepsContacts) {
  const core::Scene &was = before_.scene, &is = after_.scene;
  ASSERT_EQ(is.planes.size(), was.planes.size());
  for (std::size_t i = 0; i < was.planes.size(); ++i) {
    EXPECT_LT((is.planes[i].normal - was.planes[i].normal).norm(), rounding);
    EXPECT_NEAR(is.planes[i].offset, was.planes[i].offset, rounding);
  }
  EXPECT_EQ(core::touching_pairs(is).size(), core::touching_pairs(was).size());
  for (core::Pair pair : core::touching_pairs(was)) {
    const auto expected = core::material_of(was, pair);
    pair.body = now(pair.body), pair.other = now(pair.other);
    const auto material = core::material_of(is, pair);
    ASSERT_TRUE(material);
    EXPECT_NEAR(material->friction, expected->friction, rounding);
    EXPECT_NEAR(material->restitution, expected->restitution, rounding);
  }
  for (std::size_t i = 0; i < was.bodies.size(); ++i) {
    const core::Body& now_it_is = body_now(static_cast<int>(i));
    EXPECT_EQ(core::collides(now_it_is), core::collides(was.bodies[i])) << was.bodies[i].name;
    if (core::collides(was.bodies[i])) {
      EXPECT_NEAR(core::bounding_radius(now_it_is.shape), core::bounding_radius(was.bodies[i].shape),
                  rounding);
    }
  }
}

TEST_P(RoundTrip, KeepsGravityAndTheStep) {
  EXPECT_LT((core::gravity(after_.scene) - core::gravity(before_.scene)).norm(), rounding);
  EXPECT_DOUBLE_EQ(after_.step, before_.step);
}

// What an import names after the models of a world was refused, so that SDFormat could not go there and back.
TEST(RoundTripOfSdf, KeepsNamesOfOneModelAndOfStaticOnes) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "nested.sdf";
  if (!fs::exists(imports::program_of(*imports::format_of(file), binary_dir)))
    GTEST_SKIP() << "no libsdformat";
  const scenario::Scenario before = scenario::parse(scenes::nested, "before.toml");
  std::ofstream(file) << export_scenario(before, scenes::nested, "SDFormat").xml;
  const scenario::Scenario after =
      scenario::parse(imports::import_file(file, {}, binary_dir).toml, "after.toml");
  const auto names = [](const scenario::Scenario& scenario) {
    std::set<std::string> all;
    for (const core::Body& body : scenario.scene.bodies) all.insert(body.name);
    return all;
  };
  EXPECT_EQ(names(after), names(before));
}

// A link and a model of one name beside each other, which SDFormat does not take: one of them has a number.
TEST(RoundTripOfSdf, TakesALinkWithTheNameOfAModel) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "names.sdf";
  if (!fs::exists(imports::program_of(*imports::format_of(file), binary_dir)))
    GTEST_SKIP() << "no libsdformat";
  std::string text = scenes::several;
  for (std::size_t at; (at = text.find("\"p::n\"")) != std::string::npos;) text.replace(at, 6, "\"n::n\"");
  std::ofstream(file) << export_scenario(scenario::parse(text, "before.toml"), text, "SDFormat").xml;
  const scenario::Scenario after =
      scenario::parse(imports::import_file(file, {}, binary_dir).toml, "after.toml");
  EXPECT_EQ(after.scene.bodies.size(), 5u);
  EXPECT_EQ(after.scene.joints.size(), 3u);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, RoundTrip,
    testing::Values(Case{"machine", scenes::machine, ".xml"}, Case{"moving", scenes::moving, ".xml"},
                    Case{"loop", scenes::loop, ".xml"}, Case{"nearly_round", scenes::nearly_round, ".xml"},
                    Case{"nearly_round_in_2_", scenes::nearly_round, ".xml", true},
                    Case{"contacts", scenes::contacts, ".xml"}, Case{"hips", scenes::hips, ".xml"},
                    Case{"hips_in_2_", scenes::hips, ".xml", true}, Case{"robot", scenes::robot, ".sdf"},
                    Case{"nested", scenes::nested, ".sdf"}, Case{"several", scenes::several, ".sdf"},
                    Case{"loop", scenes::loop, ".sdf"}, Case{"bounces", scenes::bounces, ".sdf"}),
    [](const auto& test) { return std::string(test.param.name) + (test.param.ending + 1); });

}  // namespace
}  // namespace cylon::exports
