// A scene as TOML is the same scene again, to the last bit: made up, mixed, and every one that is shipped.
#include "harness/scenario/writer.h"

#include "harness/process/scene_json.h"
#include "tests/harness/view/fixture.h"
#include "tests/paths.h"

#include <toml++/toml.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

namespace cylon::scenario {
namespace {

namespace fs = std::filesystem;
using core::Vector3;
using view::ball_on_floor, view::hinged_pair;

/// A scene with one of everything that a scenario can say.
core::Scene everything() {
  core::Scene scene = hinged_pair();
  core::Body tool = process::point("tool 7", {3, 4.5, -1}, {0.1, 0.2, 0.3});
  tool.mass = 1.75;
  core::Part ball{core::Sphere{0.2}, 1, {-0.375, 0, 0}, core::Quaternion::Identity()};
  core::Part rod{core::Cylinder{0.1, 0.5},
                 0.75,
                 {0.5, 0, 0},
                 core::Quaternion(Eigen::AngleAxisd(0.4, Vector3::UnitX()))};
  tool.shape = core::Compound{{ball, rod}};
  core::Body hull = process::point("hull", {-3, 4.5, -1}, {0, 0, 0});
  hull.inertia = Vector3(0.4, 0.5, 0.6).asDiagonal();
  hull.shape = core::Hull{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, -1}}};
  hull.color = "#102030";
  core::Body anchor = process::point("anchor", {0, 9, 0}, {0, 0, 0});
  anchor.locked = true;
  scene.bodies.insert(scene.bodies.end(), {tool, hull, anchor});
  scene.forces = {core::UniformGravity{{0.1, -9.5, 0}},
                  core::Spring{0, {0.1, 0, 0}, 1, {0, 0.2, 0}, 12, 0.3, 0.4},
                  core::Spring{2, {0, 0, 0}, core::world, {1, 2, 3}, 5, 0, 0},
                  core::Drag{1, 0.1, 0.2, 0.3},
                  core::Thrust{.body = 3, .force = Vector3(0, 1, 0)},
                  core::Drive{3, {1, 0, 2}, 3.5},
                  core::Attraction{2, 3, 0.7},
                  core::Water{-20, 0.1, 0.2, 1000, 3, "volume"},
                  core::PluginForce{"mine", "law \"7\"", {3, 1}, {{"k", 0.1}, {"an odd \"name\"", -3}}},
                  core::PluginForce{"mine", "other", {0}, {}}};
  scene.planes = {{"floor", Vector3(0.6, 0.8, 0), -30, {"ground", "an odd \"name\""}, {"tools"}}};
  scene.bodies[2].collide = true;
  scene.bodies[2].gravity = Vector3(0.1, 0, -3.5), scene.bodies[3].gravity = Vector3::Zero();
  scene.bodies[2].collision_groups = {"tools"}, scene.bodies[2].collision_mask = {"ground", "tools"};
  scene.materials = {{{"*", "*"}, 0.25, 0.5}, {{"hull", "floor"}, 0.125, 0}};
  scene.impacts = core::Impacts::simultaneous;
  return scene;
}

core::Scene framed() {
  core::Scene scene = process::two_bodies();
  scene.frame = core::Frame{{0.1, 0, 0}, {0, 0.2, 0}};
  return scene;
}

/// A rod, which has no inertia about its axis: a file may not state that.
core::Scene rod() {
  core::Scene scene = process::two_bodies();
  scene.bodies[0].shape = core::Rod{0.6};
  scene.bodies[0].inertia = Vector3(0.03, 0, 0.03).asDiagonal();
  scene.bodies[0].initial.orientation = core::Quaternion(0.5, 0.5, -0.5, 0.5);
  return scene;
}

/// Every number's every bit, in the order of the loader.
std::string bits(const core::Scene& scene) { return process::to_json(scene).dump(); }

core::Scene read_again(const core::Scene& scene) {
  const std::string text = "title = \"t\"\nduration = 1.0\nstep = \"0.01\"\n" + to_toml(scene) +
                           "\n[[claim]]\nconserves = \"kinetic_energy\"\n"
                           "tolerance = {absolute = 1e9, reason = \"none\"}\n";
  return parse(text, "test.toml").scene;
}

TEST(ScenarioText, IsReadBackAsTheSameScene) {
  for (const core::Scene& scene : {everything(), framed(), rod(), ball_on_floor(1, {0.1, 0.2, 0.3}, 0.4)}) {
    const core::Scene read = read_again(scene);
    EXPECT_EQ(bits(read), bits(scene));
    EXPECT_EQ(read.forces.size(), scene.forces.size());
  }
}

TEST(ScenarioText, EveryShippedSceneIsReadBackToTheLastBit) {
  for (const auto& [folder, at_least] :
       {std::pair{"/scenarios", 80}, {"/scenarios/extremes", 60}, {"/tests/data/mixes", 3}}) {
    int read = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(std::string(source_dir) + folder)) {
      if (entry.path().extension() != ".toml" || entry.path().stem() == "expected") continue;
      const core::Scene scene = scenario::read(entry.path()).scene;
      EXPECT_EQ(bits(read_again(scene)), bits(scene)) << entry.path();
      ++read;
    }
    EXPECT_GE(read, at_least) << folder;
  }
}

TEST(ScenarioText, ComparisonDetectsOneBit) {  // the test's own negative control
  const core::Scene scene = framed();
  core::Scene other = scene;
  double& x = other.bodies[1].initial.velocity.z();
  x = std::nextafter(x, 1.0);
  EXPECT_NE(bits(read_again(other)), bits(read_again(scene)));
}

TEST(ScenarioText, GravitiesAreSummed) {
  core::Scene scene = process::two_bodies();
  scene.forces = {core::UniformGravity{{0.5, -4, 0}}, core::UniformGravity{{0.25, -2, 1}}};
  const core::Scene read = read_again(scene);
  ASSERT_EQ(read.forces.size(), 1u);
  EXPECT_EQ(std::get<core::UniformGravity>(read.forces[0]).acceleration, Vector3(0.75, -6, 1));
}

TEST(Toml, NumbersKeepTheirBits) {
  for (const double x : {-0.0, 3.0, 1e300, 5e-324, 0.1, -12.0, 1.0 / 3, 123456789012345680.0}) {
    const toml::table read = toml::parse("x = " + toml_number(x));
    ASSERT_TRUE(read["x"].is_floating_point()) << toml_number(x);
    const double found = read["x"].as_floating_point()->get();
    EXPECT_EQ(found, x);
    EXPECT_EQ(std::signbit(found), std::signbit(x));
  }
}

TEST(Toml, TextsKeepTheirCharacters) {
  for (const char* text : {"", "plain", "a \"quote\", a \\, a\nline, \x7f and \xC3\xA4", "[key] = 1 # no"})
    EXPECT_EQ(toml::parse("x = " + toml_text(text))["x"].value<std::string>(), text);
}

}  // namespace
}  // namespace cylon::scenario
