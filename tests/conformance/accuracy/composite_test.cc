// Compares the mass properties of the loader's compound with the file composite_body.
#include "harness/scenario/scenario.h"
#include "tests/conformance/accuracy/truth/truth_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace cylon::accuracy {
namespace {

std::string triple(const core::Vector3& v) {
  return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x(), v.y(), v.z());
}

// The parts of the file in one compound, all of them shifted so that the origin is no special point.
std::string compound(const json& file) {
  std::string parts;
  for (const json& p : file["params"]["parts"]) {
    const core::Quaternion q = quaternion(p["q"]);
    parts += fmt::format(
        "  {{ type = \"box\", mass = {}, half_extents = {}, position = {}, orientation = [{:.17g}, {:.17g}, "
        "{:.17g}, {:.17g}] }},\n",
        number(p["m"]), triple(vector(p["half"])), triple(vector(p["p"])), q.w(), q.x(), q.y(), q.z());
  }
  return fmt::format(
      "title = \"Compound\"\nduration = 1\nstep = 0.1\n[[body]]\nname = \"thing\"\ncollide = false\n"
      "shape = {{ type = \"compound\", parts = [\n{}] }}\n"
      "[[claim]]\nconserves = \"linear_momentum\"\ntolerance = {{ absolute = 1e-12, reason = \"rounding\" "
      "}}\n",
      parts);
}

TEST(CompositeBody, HasTheFilesMassProperties) {
  const json file = read_truth("composite_body"), &result = file["result"];
  const scenario::Scenario scenario = scenario::parse(compound(file), "compound.toml");
  const core::Body& body = scenario.scene.bodies.at(0);
  EXPECT_NEAR(body.mass, number(result["mass"]), 1e-15 * 3);
  // The parts stand about their common centre: the file's centre is where the origin of the parts has gone.
  const auto& parts = std::get<core::Compound>(body.shape).parts;
  ASSERT_EQ(parts.size(), 3u);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const core::Vector3 expected = vector(file["params"]["parts"][i]["p"]) - vector(result["center_of_mass"]);
    EXPECT_LE((parts[i].position - expected).norm(), 1e-14) << i;
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(
          body.inertia(i, j),
          number(result["inertia_world_about_com"][static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]),
          1e-14)
          << i << j;
  core::Vector3 moments = core::principal_axes(body.inertia).moments;
  std::sort(moments.begin(), moments.end());
  EXPECT_LE((moments - vector(result["principal_moments"])).norm(), 1e-14);
}

}  // namespace
}  // namespace cylon::accuracy
