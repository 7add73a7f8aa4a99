// A scene as TOML is the same scene again, to the last bit: made up, and every one that is shipped.
#include "harness/view/scenario_text.h"

#include "harness/process/scene_json.h"
#include "harness/view/toml.h"
#include "tests/harness/view/fixture.h"
#include "tests/paths.h"

#include <toml++/toml.h>

#include <cmath>
#include <filesystem>
#include <limits>

namespace cylon::view {
namespace {

namespace fs = std::filesystem;
using core::Vector3;
using Json = nlohmann::ordered_json;

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
                  core::Water{-20, 0.1, 0.2, 1000, 3, "volume"}};
  scene.planes = {{"floor", Vector3(0.6, 0.8, 0), -30}};
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

std::string text_of(const core::Scene& scene) {
  Json document = {{"title", "t"}, {"duration", 1.0}, {"step", "0.01"}};
  document.update(scene_keys(scene));
  document["claim"] = {
      {{"conserves", "kinetic_energy"}, {"tolerance", {{"absolute", 1e9}, {"reason", "none"}}}}};
  return to_toml(document);
}

/// Every number's every bit, in the order of the loader.
std::string bits(const core::Scene& scene) { return process::to_json(scene).dump(); }

core::Scene read_again(const core::Scene& scene) {
  return scenario::parse(text_of(scene), "test.toml").scene;
}

TEST(ScenarioText, IsReadBackAsTheSameScene) {
  for (const core::Scene& scene : {everything(), framed(), rod(), ball_on_floor(1, {0.1, 0.2, 0.3}, 0.4)}) {
    const core::Scene read = read_again(scene);
    EXPECT_EQ(bits(read), bits(scene));
    EXPECT_EQ(read.forces.size(), scene.forces.size());
  }
}

TEST(ScenarioText, EveryShippedSceneIsReadBackToTheLastBit) {
  int read = 0;
  for (const char* folder : {"/scenarios", "/scenarios/extremes"})
    for (const fs::directory_entry& entry :
         fs::directory_iterator(std::string(source_dir) + std::string(folder))) {
      if (entry.path().extension() != ".toml" || entry.path().stem() == "expected") continue;
      const core::Scene scene = scenario::load(entry.path()).scene;
      EXPECT_EQ(bits(read_again(scene)), bits(scene)) << entry.path();
      ++read;
    }
  EXPECT_GT(read, 100);
}

TEST(ScenarioText, ComparisonDetectsOneBit) {  // the test's own negative control
  const core::Scene scene = framed();
  core::Scene other = scene;
  double& x = other.bodies[1].initial.velocity.z();
  x = std::nextafter(x, 1.0);
  EXPECT_NE(bits(read_again(other)), bits(read_again(scene)));
}

TEST(Toml, ReadsBackAsTheSameValues) {
  const double inf = std::numeric_limits<double>::infinity();
  const Json document = {{"table", {{"inline", {{"deep", Json::array({Json{{"x", 0.1}}, Json::array()})}}}}},
                         {"plain", "behind a table in the JSON, before it in the text"},
                         {"odd key = [1]", "a \"quote\", a \\, a\nline, \x7f and \xC3\xA4"},
                         {"rows", Json::array({Json{{"name", "a"}}, Json{{"name", ""}, {"flag", true}}})},
                         {"numbers", {-0.0, 3.0, 1e300, 5e-324, 0.1, -12.0, inf, -inf, std::nan("")}},
                         {"integers", {0, -3, 9007199254740993}},
                         {"none", Json::array()}};
  const toml::table read = toml::parse(to_toml(document));
  EXPECT_EQ(read["table"]["inline"]["deep"][0]["x"].value<double>(), 0.1);
  EXPECT_EQ(read["plain"].value<std::string>(), document["plain"]);
  EXPECT_EQ(read["odd key = [1]"].value<std::string>(), document["odd key = [1]"]);
  EXPECT_EQ(read["rows"][1]["name"].value<std::string>(), "");
  EXPECT_EQ(read["rows"][1]["flag"].value<bool>(), true);
  ASSERT_EQ(read["numbers"].as_array()->size(), document["numbers"].size());
  for (std::size_t i = 0; i < document["numbers"].size(); ++i) {
    ASSERT_TRUE(read["numbers"][i].is_floating_point()) << i;
    const double wanted = document["numbers"][i], found = read["numbers"][i].as_floating_point()->get();
    EXPECT_TRUE(std::isnan(wanted) ? std::isnan(found) : wanted == found) << i;
    EXPECT_EQ(std::signbit(wanted), std::signbit(found)) << i;
  }
  for (std::size_t i = 0; i < document["integers"].size(); ++i)
    EXPECT_EQ(read["integers"][i].value_exact<std::int64_t>(), document["integers"][i].get<std::int64_t>())
        << i;
  EXPECT_FALSE(read.contains("none"));
}

TEST(Toml, RejectsUnsupportedValues) {
  EXPECT_THROW(to_toml(Json{{"a", nullptr}}), std::invalid_argument);
  EXPECT_THROW(to_toml(Json::array({1})), std::invalid_argument);
}

}  // namespace
}  // namespace cylon::view
