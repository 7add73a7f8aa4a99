// The suites as `cylon run` runs them, in process: what the conformance suite says of every engine, that it
// says the same again, and that the published table comes out digit by digit.
#include "tests/conformance/fixture.h"

#include "harness/cli/commands/published.h"
#include "harness/scenario/input.h"
#include "harness/study/cell_pool.h"
#include "harness/study/relations.h"
#include "reference/measured/claim_truth.h"
#include "reports/json.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <set>
#include <vector>

namespace cylon::conformance {
namespace {

using results::Verdict;

// A suite's cells; they point to its scenarios.
struct Cells {
  std::vector<std::unique_ptr<scenario::Scenario>> scenarios;
  std::vector<study::Cell> cells;
};

Cells cells_of(const scenario::Suite& suite) {
  Cells all;
  for (const std::string& name : suite.scenarios) {
    all.scenarios.push_back(std::make_unique<scenario::Scenario>(shipped(name)));
    const scenario::Scenario& scenario = *all.scenarios.back();
    for (const std::string& id : suite.engines) {
      if (suite.steps.empty())
        all.cells.push_back({&scenario, engine(id), scenario.step, scenario.step_text});
      for (const std::string& step : suite.steps)
        all.cells.push_back({&scenario, engine(id), scenario::parse_step(step), step});
    }
  }
  return all;
}

std::vector<Verdict> run(const Cells& all, int workers, const scenario::Expectations& expectations) {
  std::vector<Verdict> rows;
  for (auto& cell : study::run(all.cells, {.workers = workers, .limits = {}}, expectations, {}).rows)
    rows.insert(rows.end(), cell.begin(), cell.end());
  return rows;
}

scenario::Suite suite(const std::string& name) {
  return scenario::load_suite(source("scenarios/suites/" + name + ".toml"));
}

std::string place(const Verdict& row) {
  return fmt::format("{} of {} on {}: {} {:.17g}, allowed {:.17g}; {}", row.claim, row.scenario, row.engine,
                     results::name(row.status), row.measured, row.allowed, row.detail);
}

// Every field but the time that it took and whether that is verified, doubles to the last bit.
std::string content(std::vector<Verdict> rows) {
  for (Verdict& row : rows) row.cpu_seconds = 0, row.cpu_verified = false;
  return reports::to_json(rows, {});
}

class Conformance : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    expectations_ = scenario::Expectations::load(source("scenarios/expected.toml"));
    cells_ = cells_of(suite("conformance"));
    rows_ = run(cells_, 2, expectations_);
  }
  static inline scenario::Expectations expectations_;
  static inline Cells cells_;
  static inline std::vector<Verdict> rows_;
};

TEST_F(Conformance, EveryVerdictIsAsExpected) {
  ASSERT_EQ(cells_.cells.size(), 112u) << "eight scenes on fourteen engines";
  for (const Verdict& row : rows_) {
    EXPECT_TRUE(row.as_expected()) << place(row);
    EXPECT_TRUE(row.version_listed) << place(row);
  }
}

// The catalogue beside it: all other scenes, on each engine by its fair defaults and in single precision.
TEST(Catalogue, EveryVerdictIsAsExpected) {
  scenario::Suite catalogue = suite("catalogue");
  catalogue.engines.emplace_back("in-house-float");
  const Cells cells = cells_of(catalogue);
  ASSERT_GT(cells.cells.size(), 320u);
  for (const Verdict& row : run(cells, 2, scenario::Expectations::load(source("scenarios/expected.toml"))))
    EXPECT_TRUE(row.as_expected()) << place(row);
}

TEST_F(Conformance, TheInHouseDefaultPassesEveryClaim) {
  int claims = 0;
  for (const Verdict& row : rows_) {
    if (row.engine != "in-house") continue;
    EXPECT_EQ(row.status, results::Status::pass) << place(row);
    ++claims;
  }
  EXPECT_GT(claims, 0);
}

// Rows name exact cells: each must be a claim, or a relation, of a shipped scenario on an engine of a suite, or on an
// optional one, which is in none.
TEST_F(Conformance, EveryExpectationIsOfAVerdict) {
  measured::serve_scenarios();
  std::set<std::string> engines = {"in-house-float"};  // the catalogue in single precision is no suite
  for (const std::string name : {"conformance", "simbenchmark", "catalogue", "extremes"}) {
    const scenario::Suite s = suite(name);
    engines.insert(s.engines.begin(), s.engines.end());
  }
  for (const process::EngineRow& row : process::default_engines(binary_dir))
    if (row.optional()) engines.insert(row.id);
  std::map<std::string, std::set<std::string>> claims;
  for (const auto& row : expectations_.rows()) {
    auto& of = claims[row.scenario];
    if (of.empty()) {
      for (const core::Claim& claim : shipped(row.scenario).claims) of.insert(claim.label);
      for (const study::Relation& relation : study::relations())
        of.insert(fmt::format("relation {}", relation.name));
    }
    EXPECT_TRUE(of.contains(row.claim)) << row.claim << " of " << row.scenario;
    EXPECT_TRUE(engines.contains(row.engine)) << row.engine;
  }
  EXPECT_GT(claims.size(), 100u);
}

TEST_F(Conformance, EveryMetamorphicRelationIsAsExpected) {
  Cells related = cells_of(suite("conformance"));
  for (study::Cell& cell : related.cells) cell.exam = study::Exam::relations;
  const auto rows = run(related, 2, expectations_);
  int in_house = 0;
  for (const Verdict& row : rows) {
    EXPECT_TRUE(row.as_expected()) << place(row);
    if (row.engine != "in-house") continue;
    EXPECT_EQ(row.status, results::Status::pass) << place(row);
    ++in_house;
  }
  EXPECT_GT(in_house, 60) << "eight scenes, a dozen relations less those that say nothing of them";
}

// Whoever states an order or a bound is held to it: in-house, each of its schemes, Bullet and ODE.
TEST_F(Conformance, EveryClaimByTheoryIsAsExpected) {
  Cells cells = cells_of(suite("conformance"));
  for (study::Cell& cell : cells.cells) cell.exam = study::Exam::theory;
  const auto rows = run(cells, 2, expectations_);
  int in_house = 0;
  for (const Verdict& row : rows) {
    EXPECT_TRUE(row.as_expected()) << place(row) << ": " << row.measured << " of " << row.allowed;
    if (!row.engine.starts_with("in-house") || row.engine == "in-house-float") continue;
    if (row.detail.starts_with("Theory bounds nothing")) {
      EXPECT_EQ(row.status, results::Status::undecided) << place(row);
      continue;
    }
    EXPECT_EQ(row.status, results::Status::pass) << place(row);
    ++in_house;
  }
  EXPECT_GT(in_house, 90)
      << "eight scenes, five schemes, two claims or more, less what first order leaves open";
}

TEST_F(Conformance, RowsAreTheSameForAnyNumberOfWorkersAndAgain) {
  EXPECT_EQ(content(run(cells_, 1, expectations_)), content(rows_)) << "one worker, then two";
}

TEST_F(Conformance, EveryTruthIsTenTimesFinerThanItsTolerance) {
  int truths = 0;
  for (const Verdict& row : rows_) {
    if (row.claim.find(" follows ") == std::string::npos) continue;
    EXPECT_LT(row.truth_error, row.allowed / 10) << place(row);
    EXPECT_GT(row.truth_error, 0) << place(row);
    ++truths;
  }
  EXPECT_GT(truths, 0);
}

TEST(SimBenchmark, ReproducesEveryPublishedDigit) {
  const scenario::Suite table = suite("simbenchmark");
  ASSERT_EQ(table.published.size(), 10u);
  auto rows = run(cells_of(table), 2, {});
  std::erase_if(rows, [&](const Verdict& row) { return row.claim != table.claim; });
  ASSERT_EQ(rows.size(), 10u) << "each published number has a row";
  const cli::Reproduction result = cli::reproduce(table, rows);
  EXPECT_TRUE(result.complete) << result.text;
}

// The table's factor of four hundred is no engine's but a solver path's: Bullet's other path has ODE's
// digits.
TEST(SimBenchmark, BulletRigidAgreesWithOde) {
  const scenario::Suite table = suite("simbenchmark");
  const auto ode = std::find_if(table.published.begin(), table.published.end(), [](const auto& number) {
    return number.engine.starts_with("ode") && number.dt == "0.001";
  });
  ASSERT_NE(ode, table.published.end());
  const double measured = verdict(shipped("simbenchmark_bouncing"), "bullet", 0.001).measured;
  EXPECT_TRUE(cli::same_digits(measured, ode->value))
      << measured << " here, " << ode->value << " published of ODE";
}

}  // namespace
}  // namespace cylon::conformance
