// Small scenes on which the in-house engine was found wrong, slow or silent, or might be.  Each ends after a
// bounded number of operations, and either moves as it must or says in a remark what was not kept.
#include "engine/world.h"
#include "harness/scenario/scenario.h"
#include "reference/simulators/in_house/in_house_model.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace cylon {
namespace {

enum class What { position, velocity };

/// A component of a body's motion at the end.
struct Truth {
  int body = 0;
  What what = What::position;
  int axis = 0;
  double value = 0, tolerance = 0;
};

struct Odd {
  const char* name;       ///< Of tests/odd/NAME.toml.
  double operations;      ///< At most: 1.5 to 3 times what was counted.
  const char* said = "";  ///< A part of a remark that the run must make; "": the tolerance is kept.
  std::vector<Truth> truths = {};
  const char* path = "";  ///< That is asked for.
  friend std::ostream& operator<<(std::ostream& out, const Odd& odd) { return out << odd.name; }
};

constexpr const char* not_followed = "had more events than are followed";

// Ball that rolls on two lines of contact at the distance a below its centre, from the speed v of sliding:
//   m (v - v') = J,  2/5 m r^2 w = J a,  v' = a w   =>   v' = v k/(1 + k),  k = a^2/(2/5 r^2)
double rolls(double a, double r, double v) {
  const double k = a * a / (0.4 * r * r);
  return v * k / (1 + k);
}

// x = x_0 + v t - mu g t^2/2, to where it rests.
double slides_to(double t) {
  const double a = 0.2 * 9.81, rest = std::min(t, 3 / a);
  return 0.2 + 3 * rest - a * rest * rest / 2;
}

constexpr const char* stepped = "not controlled";

const double sqrt_half = std::sqrt(0.5);
const double rail_height = 0.2 + std::sqrt(0.36 - 0.35 * 0.35);

const std::vector<Odd> all = {
    // Contacts that stick, slip and bounce without end: minutes for seconds of motion, before.
    {"groove",
     8e6,
     "",
     {{0, What::velocity, 2, rolls(0.5 * sqrt_half, 0.5, 1), 1e-10},
      {0, What::position, 1, sqrt_half, 1e-10}}},
    {"groove_smooth", 5e6, "", {{0, What::velocity, 2, 1, 1e-12}, {0, What::position, 2, 2, 1e-12}}},
    {"groove_steep", 6e6},
    {"groove_shallow", 5e6},
    // One rail is struck before the other: the ball swings about it for 0.3 s.
    {"two_rails",
     6e6,
     "",
     {{2, What::velocity, 2, rolls(0.5 * (rail_height - 0.2) / 0.6, 0.5, 1), 1e-5},
      {2, What::position, 1, rail_height, 1e-10}}},
    {"two_rails_smooth", 5e6, "", {{2, What::velocity, 2, 1, 1e-12}}},
    {"two_rails_off_centre", 1e8, not_followed, {{2, What::position, 1, rail_height, 1e-6}}},
    {"five_balls_weak_spring", 3e8, "late", {{0, What::position, 1, 0.5, 1e-6}}},
    {"five_balls", 3e8, "late", {{0, What::position, 1, 0.5, 1e-6}}},
    {"hull_on_box", 1.5e7, "", {{1, What::velocity, 1, 0, 1e-9}}},
    {"hull_on_plane", 6e6, "", {{0, What::velocity, 1, 0, 1e-9}}},
    {"tetrahedron_on_box", 5e6, "iteratively", {{1, What::position, 1, 0.75, 1e-9}}},
    {"capsule_on_box", 1.5e7, "", {{1, What::position, 1, 0.7, 1e-9}}},
    {"box_on_box", 6e6, "", {{1, What::position, 1, 0.7, 1e-9}}},
    {"box_on_plane", 5e6, "", {{0, What::position, 1, 0.2, 1e-9}}},
    {"box_in_corner", 3e7, "", {{0, What::velocity, 1, 0, 1e-9}}},
    // Ghost collisions at the seams of coplanar boxes: 3 m/s became 1.13, or 0.23.
    {"box_over_seams", 1e8, "", {{0, What::position, 0, 9.2, 1e-9}, {0, What::velocity, 0, 3, 1e-9}}},
    {"box_over_seams",
     0,
     stepped,
     {{0, What::position, 0, 9.2, 1e-9}, {0, What::velocity, 0, 3, 1e-9}},
     "stepping"},
    {"box_over_seams_rough", 1e8, "", {{0, What::position, 0, slides_to(2), 1e-8}}},
    {"box_over_seams_rough", 0, stepped, {{0, What::position, 0, slides_to(2), 0.01}}, "stepping"},
    {"box_over_unequal_seams", 1e8, "", {{0, What::position, 0, 6.2, 1e-9}, {0, What::velocity, 0, 3, 1e-9}}},
    {"box_over_unequal_seams", 0, stepped, {{0, What::position, 0, 6.2, 1e-9}}, "stepping"},
    {"ball_over_seams", 1e8, "", {{0, What::velocity, 0, 3, 1e-9}, {0, What::position, 1, 0.25, 1e-9}}},
    {"ball_over_seams", 0, stepped, {{0, What::velocity, 0, 3, 1e-9}}, "stepping"},
    {"ball_over_seams_smooth", 1e8, "", {{0, What::velocity, 0, 3, 1e-9}}},
    {"ball_over_seams_smooth", 0, stepped, {{0, What::velocity, 0, 3, 1e-9}}, "stepping"},
    // What does stand in the way.
    {"box_against_a_step", 1e8, "", {{0, What::velocity, 0, 0, 2.5}}},
    {"box_against_a_step", 0, stepped, {{0, What::velocity, 0, 0, 2.5}}, "stepping"},
    {"box_against_a_wall", 1e8, "", {{0, What::velocity, 0, -1.5, 1e-9}}},
    {"box_against_a_wall", 0, stepped, {{0, What::velocity, 0, -1.5, 1e-9}}, "stepping"},
    {"hinge_chain", 2e9, not_followed, {}, "events"},
    {"jointed_boxes", 1.5e8, not_followed, {{0, What::position, 1, 0.2, 1e-6}}, "events"},
    {"break_of_sixteen", 3e8, not_followed, {{0, What::position, 1, 0.0286, 1e-6}}, "events"},
};

class OddScenes : public testing::TestWithParam<Odd> {};

TEST_P(OddScenes, EndsAndSaysHowWell) {
  const Odd& odd = GetParam();
  const scenario::Scenario scenario =
      scenario::load(std::filesystem::path(source_dir) / "tests/odd" / (std::string(odd.name) + ".toml"));
  const simulators::InHouseModel translated = simulators::in_house_model(scenario.scene);
  ASSERT_FALSE(translated.missing.has_value()) << *translated.missing;
  engine::Options options;
  options.dt = scenario.step;
  options.path = odd.path;
  ASSERT_EQ(engine::unsupported(translated.model, options), "");
  engine::World world(translated.model, options);
  const std::int64_t steps = std::llround(scenario.duration / scenario.step);
  for (std::int64_t k = 0; k < steps; ++k) world.step();

  EXPECT_LE(static_cast<double>(world.operations()), odd.operations);
  for (std::size_t i = 0; i < world.motions().size(); ++i)
    EXPECT_TRUE(world.motions()[i].position.allFinite() && world.motions()[i].momentum.allFinite()) << i;
  for (const Truth& truth : odd.truths) {
    const auto i = static_cast<std::size_t>(truth.body);
    const engine::Motion& motion = world.motions()[i];
    const engine::Vector3 at =
        truth.what == What::position ? motion.position : engine::velocity(world.bodies()[i], motion);
    EXPECT_NEAR(static_cast<double>(at[truth.axis]), truth.value, truth.tolerance) << "body " << truth.body;
  }
  const std::vector<std::string> remarks = world.remarks();
  const auto says = [&](std::string_view part) {
    return std::any_of(remarks.begin(), remarks.end(),
                       [&](const std::string& remark) { return remark.find(part) != std::string::npos; });
  };
  if (*odd.said != '\0') {
    EXPECT_TRUE(says(odd.said));
    return;
  }
  for (const char* lost : {"not reached", "not kept", "not controlled", not_followed, "iteratively", "late"})
    EXPECT_FALSE(says(lost)) << lost;
}

INSTANTIATE_TEST_SUITE_P(All, OddScenes, testing::ValuesIn(all), [](const auto& row) {
  return std::string(row.param.name) + (*row.param.path ? "_" : "") + row.param.path;
});

// Every file is in the table.
TEST(OddScenesTable, HasEveryFile) {
  std::set<std::string> names, files;
  for (const Odd& odd : all) names.insert(odd.name);
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(source_dir) / "tests/odd"))
    if (entry.path().extension() == ".toml") files.insert(entry.path().stem().string());
  EXPECT_EQ(names, files);
}

}  // namespace
}  // namespace cylon
