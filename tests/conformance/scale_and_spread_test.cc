// Two options of a study: a factor on all tolerances, which every report shows, and copies that start one ulp
// apart.
#include "harness/study/spread.h"
#include "reports/console.h"
#include "reports/csv.h"
#include "reports/json.h"
#include "reports/junit.h"
#include "tests/conformance/fixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace cylon::conformance {
namespace {

std::vector<results::Verdict> judged(const scenario::Scenario& scenario, double scale, int copies,
                                     study::Exam exam = study::Exam::claims) {
  study::Cell cell{&scenario, engine("in-house"), scenario.step, scenario.step_text, "", ""};
  cell.tolerance_scale = scale, cell.copies = copies, cell.exam = exam;
  return study::run(cell, process::Limits{}, scenario::Expectations{});
}

TEST(ToleranceScale, MultipliesWhatIsAllowedAndNothingElse) {
  const auto scenario = shipped("two_sphere_oblique");
  const auto plain = judged(scenario, 1, 0), half = judged(scenario, 0.5, 0);
  ASSERT_EQ(plain.size(), half.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_EQ(half[i].measured, plain[i].measured) << plain[i].claim;
    EXPECT_EQ(half[i].allowed, 0.5 * plain[i].allowed) << plain[i].claim;
    EXPECT_EQ(plain[i].tolerance_scale, 1);
    EXPECT_EQ(half[i].tolerance_scale, 0.5);
  }
}

// At zero nothing passes, a residual of zero neither, and every number is there.
TEST(ToleranceScale, ZeroShowsAllResiduals) {
  for (const results::Verdict& row : judged(shipped("two_sphere_oblique"), 0, 0)) {
    EXPECT_EQ(row.status, results::Status::fail) << row.claim;
    EXPECT_TRUE(std::isfinite(row.measured)) << row.claim;
    EXPECT_EQ(row.allowed, 0) << row.claim;
  }
}

TEST(ToleranceScale, AppearsInEveryReport) {
  const auto scenario = shipped("projectile");
  const auto rescaled = judged(scenario, 3, 0), plain = judged(scenario, 1, 0);
  reports::Provenance provenance;
  provenance.tolerance_scale = 3;
  struct Report {
    const char* what;
    std::string with, without, sign;
  };
  for (const Report& report :
       {Report{"json", reports::to_json(rescaled, provenance), reports::to_json(plain, {}),
               "\"tolerance_scale\":3.0"},
        Report{"junit", reports::to_junit(rescaled), reports::to_junit(plain), "all tolerances times 3"},
        Report{"matrix", reports::console_matrix(rescaled, {}), reports::console_matrix(plain, {}),
               "all tolerances are multiplied by 3"},
        Report{"details", reports::console_details(rescaled, {}), reports::console_details(plain, {}),
               "all tolerances are multiplied by 3"}}) {
    EXPECT_NE(report.with.find(report.sign), std::string::npos) << report.what;
    EXPECT_EQ(report.without.find(report.sign), std::string::npos) << report.what;
  }
  EXPECT_NE(reports::to_csv(rescaled).find("tolerance_scale"), std::string::npos);
  EXPECT_NE(reports::to_csv(rescaled), reports::to_csv(plain));
  const auto again = reports::read_json(reports::to_json(rescaled, provenance), "again.json").verdicts;
  EXPECT_EQ(again.at(0).tolerance_scale, 3);
}

// ---- Copies --------------------------------------------------------------------------------------

TEST(OneUlpApart, ChangesOneCoordinateByOneUlp) {
  const core::Scene scene = shipped("kepler").scene;
  std::set<std::pair<std::size_t, int>> changed;
  for (int copy = 0; copy < 3; ++copy) {
    const core::Scene nudged = study::one_ulp_apart(scene, copy, 3);
    int differences = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
      for (int k = 0; k < 6; ++k) {
        const auto coordinate = [&](const core::Scene& s) {
          const core::BodyState& state = s.bodies[i].initial;
          return k < 3 ? state.position[k] : state.velocity[k - 3];
        };
        if (coordinate(nudged) == coordinate(scene)) continue;
        EXPECT_EQ(coordinate(nudged), std::nextafter(coordinate(scene), HUGE_VAL));
        changed.insert({i, k});
        ++differences;
      }
    EXPECT_EQ(differences, 1) << copy;
  }
  EXPECT_EQ(changed.size(), 3u) << "another coordinate for each copy";
}

TEST(OneUlpApart, SkipsLockedBodiesAndChangesZeros) {
  core::Scene scene;
  scene.bodies.resize(1);
  EXPECT_EQ(study::one_ulp_apart(scene, 0, 1).bodies[0].initial.position.x(), 0x1p-52);
  scene.bodies.resize(2);
  scene.bodies[0].initial.position = {1, 2, 3};
  scene.bodies[0].locked = true;
  scene.bodies[1].initial.velocity = {0, 5, 0};
  for (int copy = 0; copy < 4; ++copy) {
    const core::Scene nudged = study::one_ulp_apart(scene, copy, 4);
    EXPECT_EQ(nudged.bodies[0].initial.position, core::Vector3(1, 2, 3));
    EXPECT_GT(nudged.bodies[1].initial.velocity.y(), 5);
  }
}

double largest_spread(const char* name, int copies) {
  double result = 0;
  for (const results::Verdict& row : judged(shipped(name), 1, copies)) {
    EXPECT_TRUE(row.spread) << name << ", " << row.claim;
    if (row.claim.starts_with("position")) result = std::max(result, row.spread.value_or(0));
  }
  return result;
}

// An ulp of a metre is 2e-16 m.  A stone's flight keeps it; a double pendulum, tagged chaos, magnifies it,
// and its spread stands beside the verdict without being asked for.
TEST(Spread, DistinguishesChaosFromRegularMotion) {
  const double regular = largest_spread("projectile", 2), chaotic = largest_spread("double_pendulum", 0);
  EXPECT_GT(regular, 0);
  EXPECT_LT(regular, 1e-14);
  EXPECT_GT(chaotic, 100 * regular);
  for (const results::Verdict& row : judged(shipped("projectile"), 1, 0))
    EXPECT_FALSE(row.spread) << row.claim;
  EXPECT_NE(judged(shipped("double_pendulum"), 1, 0).at(0).detail.find("2 runs that start one ulp apart end"),
            std::string::npos);
}

// `--spread` was taken and did nothing there.  In units of the scene's scales.
TEST(Spread, StandsBesideTheRelationsToo) {
  const auto relations = [](const char* name, int copies) {
    return judged(shipped(name), 1, copies, study::Exam::relations);
  };
  const auto regular = relations("projectile", 2), chaotic = relations("double_pendulum", 0);
  for (const auto* rows : {&regular, &chaotic})
    for (const results::Verdict& row : *rows) {
      ASSERT_TRUE(row.spread) << row.claim;
      EXPECT_NE(row.detail.find("2 runs that start one ulp apart end"), std::string::npos) << row.detail;
    }
  EXPECT_LT(*regular.front().spread, 1e-14);
  EXPECT_GT(*chaotic.front().spread, 100 * *regular.front().spread);
  EXPECT_FALSE(relations("projectile", 0).front().spread);
}

}  // namespace
}  // namespace cylon::conformance
