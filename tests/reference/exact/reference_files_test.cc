// Every exact solution against the reference files: 21 digits, two unrelated methods, rigorous enclosures.
#include "harness/core/truth.h"
#include "reference/exact/catalogue.h"
#include "tests/reference/exact/reference_file.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <limits>

namespace cylon::exact {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

core::Truth make(std::string_view name, const core::Scene& scene, double horizon) {
  for (const Solution& solution : catalogue()) {
    if (solution.name == name) return solution.make(scene, horizon);
  }
  throw std::runtime_error("no solution " + std::string(name));
}

struct Case {
  const char* file;
  const char* solution;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.file; }

// Largest differences, sizes, and angle turned through over the file's samples.
struct Comparison {
  core::StateError difference, size;
  double turned = 0;

  Comparison(const ReferenceFile& file, const core::Truth& truth) {
    size.orientation = 1;
    double fastest = 0;
    for (std::size_t k = 0; k < file.times.size(); ++k) {
      const core::State state = truth.state(file.times[k]);
      for (std::size_t b = 0; b < state.size(); ++b) {
        const core::BodyState &s = state[b], &r = file.states[k][b];
        const auto most = [](double& a, double b_) { a = std::max(a, b_); };
        most(difference.position, (s.position - r.position).norm()), most(size.position, r.position.norm());
        most(difference.velocity, (s.velocity - r.velocity).norm()), most(size.velocity, r.velocity.norm());
        most(size.angular_velocity, r.angular_velocity.norm());
        most(fastest, r.angular_velocity.norm());
        if (!file.has_rotation) continue;
        most(difference.orientation, angle_between(s.orientation, r.orientation));
        most(difference.angular_velocity, (s.angular_velocity - r.angular_velocity).norm());
      }
    }
    turned = fastest * file.horizon;
  }
};

class ReferenceFiles : public testing::TestWithParam<Case> {};

// allowed = max(1e-13 S, 4 eps max(conditioning, total angle)): what a solution in double can promise, as the
// file's own numbers were rounded to double.  dzhanibekov: 4 eps 22160 = 2.0e-11.
TEST_P(ReferenceFiles, states_agree_and_the_bound_covers_the_difference) {
  const ReferenceFile file(GetParam().file);
  const core::Truth truth = make(GetParam().solution, file.scene, file.horizon);
  ASSERT_FALSE(truth.source.empty());
  const Comparison c(file, truth);
  const double rule = 4 * eps * std::max(file.conditioning, c.turned);
  const auto check = [&](const char* what, double core::StateError::*of) {
    const double difference = c.difference.*of, allowed = std::max(1e-13 * (c.size.*of), rule),
                 bound = truth.error.*of;
    fmt::print("{:30} {:17} difference {:8.1e}  bound {:8.1e}  allowed {:8.1e}\n", GetParam().file, what,
               difference, bound, allowed);
    EXPECT_LE(difference, allowed) << what;
    EXPECT_LE(difference, bound) << what << ": the stated bound does not hold";
    // Not absurdly loose: within ten times what the rule grants, in the quantity's own size.
    EXPECT_LE(bound, 10 * std::max(1.0, c.size.*of) * std::max(1e-13, rule)) << what;
  };
  check("position", &core::StateError::position);
  check("velocity", &core::StateError::velocity);
  if (file.has_rotation) {
    check("orientation", &core::StateError::orientation);
    check("angular_velocity", &core::StateError::angular_velocity);
  }
}

INSTANTIATE_TEST_SUITE_P(
    all, ReferenceFiles,
    testing::Values(
        Case{"projectile", "projectile"}, Case{"bouncing_sphere", "bouncing_sphere"},
        Case{"two_sphere_oblique", "two_sphere_oblique"}, Case{"sphere_two_walls", "sphere_two_walls"},
        Case{"slide_to_roll", "slide_to_roll"}, Case{"spring_zero_length", "spring_zero_length"},
        Case{"spring_orbit", "spring_orbit"}, Case{"free_symmetric_top", "free_symmetric_top"},
        Case{"free_symmetric_top", "free_asymmetric_top"}, Case{"free_asymmetric_top", "free_asymmetric_top"},
        Case{"dzhanibekov", "dzhanibekov"}, Case{"projectile_drag", "projectile_drag"},
        Case{"rocket", "rocket"}, Case{"accretion", "accretion"},
        Case{"damped_spring_under", "damped_spring_under"},
        Case{"damped_spring_critical", "damped_spring_critical"},
        Case{"damped_spring_over", "damped_spring_over"}, Case{"driven_spring", "driven_spring"},
        Case{"damped_spring_over", "driven_spring"}, Case{"constant_spin", "constant_spin"},
        Case{"damped_free_top", "damped_free_top"}, Case{"physical_pendulum", "physical_pendulum"},
        Case{"spherical_pendulum", "spherical_pendulum"}, Case{"spring_chain", "spring_chain"},
        Case{"water_step_force", "water_step_force"}, Case{"heavy_top_cusp", "heavy_top"},
        Case{"heavy_top_loops", "heavy_top"}, Case{"heavy_top_nutating", "heavy_top"},
        Case{"heavy_top_slow_spin", "heavy_top"}, Case{"heavy_top_steady_slow", "heavy_top"},
        Case{"heavy_top_steady_fast", "heavy_top"}, Case{"heavy_top_sleeping_stable", "heavy_top"},
        Case{"heavy_top_sleeping_unstable", "heavy_top"}),
    [](const auto& parameter) {
      return std::string(parameter.param.file) + "_by_" + parameter.param.solution;
    });

TEST(ReferenceEvents, bounces_and_apexes) {
  const ReferenceFile file("bouncing_sphere");
  const core::Truth truth = make("bouncing_sphere", file.scene, file.horizon);
  const double radius = number(file.data["params"]["r"]);
  double worst_time = 0;
  int bounces = 0, apexes = 0;
  for (const json& e : file.data["events"]) {
    if (e["type"] != "bounce") continue;
    ++bounces;
    const int n = e["n"];
    const double time = number(e["t"]), speed = number(e["vy_after"]),
                 gravity = number(file.data["params"]["g"]);
    const auto event = [&](core::EventKind kind) -> const core::Event* {
      for (const core::Event& x : truth.events) {
        if (x.kind == kind && x.index == n) return &x;
      }
      return nullptr;
    };
    const core::Event* bounce = event(core::EventKind::bounce);
    ASSERT_TRUE(bounce) << n;
    worst_time = std::max(worst_time, std::abs(bounce->time - time));
    EXPECT_NEAR(bounce->speed, speed, 1e-13 * 10);
    EXPECT_EQ(bounce->pair, (core::Pair{0, core::world, 0}));
    const core::Event* apex = event(core::EventKind::apex);
    if (time + speed / gravity > file.horizon) {
      EXPECT_FALSE(apex) << n;
      continue;
    }
    ASSERT_TRUE(apex) << n;
    ++apexes;
    EXPECT_NEAR(apex->time, time + speed / gravity, 1e-13 * 5);
    EXPECT_NEAR(apex->height, number(e["apex_y_after"]) - radius, 1e-13);
  }
  EXPECT_EQ(truth.events.size(), static_cast<std::size_t>(bounces + apexes));
  EXPECT_EQ(bounces, 9);
  EXPECT_LE(worst_time, 1e-13 * file.horizon);
  EXPECT_LE(worst_time, truth.error.time);
  fmt::print("bouncing_sphere                event time        difference {:8.1e}  bound {:8.1e}\n",
             worst_time, truth.error.time);
}

TEST(ReferenceEvents, oblique_impact) {
  const ReferenceFile file("two_sphere_oblique");
  const core::Truth truth = make("two_sphere_oblique", file.scene, file.horizon);
  ASSERT_EQ(truth.events.size(), 1u);
  const json& impact = file.data["events"][0];
  const core::Vector3 n = vector(impact["normal_A_to_B"]);
  const double time = number(impact["t"]);
  const double speed = n.dot(vector(impact["vB_after"]) - vector(impact["vA_after"]));
  EXPECT_NEAR(truth.events[0].time, time, 1e-13);
  EXPECT_LE(std::abs(truth.events[0].time - time), truth.error.time);
  EXPECT_NEAR(truth.events[0].speed, speed, 1e-13 * 4);
  EXPECT_EQ(truth.events[0].pair, (core::Pair{0, 1, -1}));
}

}  // namespace
}  // namespace cylon::exact
