// The extremes suite on every engine: each verdict as expected.toml says, ours a pass or a reason, and what
// solvers print is kept.
#include "tests/conformance/fixture.h"

#include "harness/study/cell_pool.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <vector>

namespace cylon::conformance {
namespace {

using results::Verdict;

const scenario::Suite& suite() {
  static const scenario::Suite loaded = scenario::load_suite(source("scenarios/suites/extremes.toml"));
  return loaded;
}

std::vector<Verdict> run_all() {
  std::vector<std::unique_ptr<scenario::Scenario>> scenes;
  std::vector<study::Cell> cells;
  for (const std::string& name : suite().scenarios) {
    scenes.push_back(std::make_unique<scenario::Scenario>(shipped(name)));
    for (const std::string& id : suite().engines)
      cells.push_back({scenes.back().get(), engine(id), scenes.back()->step, scenes.back()->step_text});
  }
  const auto expectations = scenario::Expectations::load(source("scenarios/expected.toml"));
  std::vector<Verdict> rows;
  for (auto& cell : study::run(cells, {.workers = 2, .limits = {}}, expectations, {}).rows)
    rows.insert(rows.end(), cell.begin(), cell.end());
  return rows;
}

const std::vector<Verdict>& rows() {
  static const std::vector<Verdict> all = run_all();
  return all;
}

std::string place(const Verdict& row) {
  return fmt::format("{} of {} on {}: {} (expected {}) {:.17g}, allowed {:.17g}; {}", row.claim, row.scenario,
                     row.engine, results::name(row.status), results::name(row.expected), row.measured,
                     row.allowed, row.detail);
}

TEST(Extremes, EveryVerdictIsAsExpected) {
  for (const Verdict& row : rows()) EXPECT_TRUE(row.as_expected()) << place(row);
}

TEST(Extremes, EveryFileOfTheFolderIsInTheSuiteAndTagged) {
  std::set<std::string> listed(suite().scenarios.begin(), suite().scenarios.end()), files;
  for (const auto& entry : std::filesystem::directory_iterator(source("scenarios/extremes")))
    if (entry.path().extension() == ".toml") files.insert(entry.path().stem().string());
  EXPECT_EQ(listed, files);
  for (const std::string& name : files) {
    const auto tags = shipped(name).tags;
    EXPECT_NE(std::find(tags.begin(), tags.end(), "extreme"), tags.end()) << name;
  }
}

// No engine takes the suite down, hangs in it, or breaks the protocol.  ODE's abort on an overflow is its
// own.
TEST(Extremes, NoCellEndsInTimeoutOrProtocolError) {
  for (const Verdict& row : rows()) {
    EXPECT_NE(row.status, results::Status::timeout) << place(row);
    EXPECT_NE(row.status, results::Status::protocol) << place(row);
    EXPECT_TRUE(row.status != results::Status::crash || row.engine.starts_with("ode")) << place(row);
  }
}

// A solver that complains and goes on is a finding: what it printed stands in the row.  docs/extremes.md
// names these scenes.
TEST(Extremes, OdeSolverComplainsInElevenScenes) {
  const std::set<std::string> eleven = {"cradle_60hz",     "creep_at_nine_tenths", "far_bystander",
                                        "far_pyramid",     "mass_ratio_100",       "mass_ratio_10000",
                                        "pyramid_top_100", "pyramid_top_300",      "slab_on_large_triangles",
                                        "stack_20",        "stack_top_1000"};
  std::set<std::string> complained;
  for (const Verdict& row : rows()) {
    if (row.complaints.find("LCP internal error") == std::string::npos) continue;
    EXPECT_EQ(row.engine, "ode") << place(row);
    complained.insert(row.scenario);
  }
  EXPECT_EQ(complained, eleven);
}

}  // namespace
}  // namespace cylon::conformance
