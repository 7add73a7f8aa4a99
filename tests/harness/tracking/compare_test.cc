// Comparison of two builds: order of the pairs, effect of machine drift, skipped cells and
// findings.
#include "harness/study/compare.h"

#include "harness/process/failure.h"
#include "harness/process/opening.h"
#include "harness/scenario/scenario.h"
#include "harness/study/paired_times.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

namespace cylon::study {
namespace {

namespace fs = std::filesystem;
using results::Finding;

// ---- Pairs -------------------------------------------------------------------------------------------

TEST(PairedTimes, RunsInOrderAbbaBaab) {
  std::string order;
  const auto take = [&](char name) {
    return [&order, name] {
      order += name;
      return Sample{1.25e-3 + 1e-9 * static_cast<double>(order.size()), ""};
    };
  };
  PairedTimes pairs(take('A'), take('B'), {});
  for (int i = 0; i < 8; ++i) pairs.take_pair();
  EXPECT_EQ(order, "ABBABAABABBABAAB");
}

/// A machine on which everything gets slower by 0.7 % with each sample, and 1 % of noise.
class Drifting {
 public:
  Sample operator()(double own) {
    clock_ *= 1.007;
    return {own * clock_ * (1 + 0.01 * noise_(random_)), ""};
  }

 private:
  double clock_ = 3e-3;
  std::mt19937_64 random_{20240607};
  std::uniform_real_distribution<double> noise_{-1, 1};
};

results::ComparedTime timed(Drifting& machine, double first, double second) {
  PairedTimes pairs([&] { return machine(first); }, [&] { return machine(second); }, {});
  while (pairs.wants_more()) pairs.take_pair();
  return pairs.summary();
}

TEST(PairedTimes, MachineDriftNeitherCausesNorHidesRegressions) {
  Drifting machine;
  EXPECT_EQ(timed(machine, 1.3, 1.3).finding, Finding::same);
  const results::ComparedTime slower = timed(machine, 1.3, 1.3 * 1.06);
  EXPECT_EQ(slower.finding, Finding::regressed);
  EXPECT_NEAR(slower.ratio, 1.06, 0.01);  // the noise of some tens of pairs
  EXPECT_EQ(timed(machine, 1.3 * 1.06, 1.3).finding, Finding::improved);
  // Negative control: one after the other, the same drift looks like a regression.
  double before = 0, after = 0;
  for (int i = 0; i < 10; ++i) before += machine(1.3).seconds;
  for (int i = 0; i < 10; ++i) after += machine(1.3).seconds;
  EXPECT_GT(after / before, 1.05);
}

TEST(PairedTimes, StopsAndReportsFailure) {
  int taken = 0;
  PairedTimes pairs(
      [] {
        return Sample{1e-3, ""};
      },
      [&] {
        return ++taken < 3 ? Sample{1e-3, ""} : Sample{0, "crash: killed by SIGSEGV"};
      },
      {});
  while (pairs.wants_more()) pairs.take_pair();
  EXPECT_EQ(pairs.candidate_failure(), "crash: killed by SIGSEGV");
  EXPECT_EQ(pairs.baseline_failure(), "");
  EXPECT_EQ(pairs.log_ratios().size(), 2u);
}

TEST(PairedTimes, FewerPairsKeepErrorRate) {
  for (const int most : {8, 10, 11, 24, 40}) {
    const statistics::PairedRule rule = up_to({}, most);
    EXPECT_EQ(rule.looks.back().pairs, most);
    double shares = 0;
    for (const auto& look : rule.looks) shares += look.share;
    EXPECT_NEAR(shares, 1, 1e-12) << most;
  }
  EXPECT_THROW(up_to({}, 7), std::invalid_argument);
}

TEST(Sampler, TakesLeastSumOfNeighbours) {
  const std::vector<process::Repetition> all = {{9, 3}, {9, 5}, {1, 4}, {1, 2.5}, {0.5, 1}};
  EXPECT_DOUBLE_EQ(least_of(all, 1, false), 1);
  EXPECT_DOUBLE_EQ(least_of(all, 2, false), 3.25);  // 4 + 2.5; the odd one out counts for nothing
  EXPECT_DOUBLE_EQ(least_of(all, 2, true), 4.25);
}

// ---- Metrics that repeat -----------------------------------------------------------------------------

Profile profile_with(double error, double floor, double order, const std::string& hash) {
  Profile p;
  p.facts = {hash, 7, 4};
  p.claims = {{.claim = "position", .unit = "m", .error = error, .floor = floor, .order = order}};
  return p;
}

TEST(Metrics, ErrorsAndOrdersByTheirRules) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const struct {
    const char* what;
    double error, order;
    const char* hash;
    Finding finding;
  } cases[] = {
      {"the same", 3.7e-6, 3.98, "a", Finding::same},
      {"other bits alone", 3.7e-6, 3.98, "b", Finding::changed},
      {"9 % worse", 3.7e-6 * 1.09, 3.98, "b", Finding::changed},
      {"12 % worse", 3.7e-6 * 1.12, 3.98, "b", Finding::regressed},
      {"half the error", 1.85e-6, 3.98, "b", Finding::improved},
      {"an order lost", 3.7e-6, 2.98, "b", Finding::regressed},
      {"no number", nan, 3.98, "b", Finding::regressed},
  };
  const Profile before = profile_with(3.7e-6, 1e-12, 3.98, "a");
  for (const auto& c : cases) {
    results::Comparison row;
    row.metrics = compare_profiles(before, profile_with(c.error, 1e-12, c.order, c.hash));
    EXPECT_EQ(results::worst_finding(row), c.finding) << c.what;
  }
}

TEST(Metrics, IgnoresRoundingAndMissingOrders) {
  results::Comparison row;
  row.metrics =
      compare_profiles(profile_with(2e-14, 5e-13, 1.44, "a"), profile_with(3e-13, 5e-13, 0.61, "a"));
  EXPECT_EQ(results::worst_finding(row), Finding::same);
}

TEST(Metrics, CountsOfInstructionsFromDifferentCountersAreNotCompared) {
  Profile before = profile_with(1e-6, 0, 4, "a"), after = before;
  before.instructions = {
      .counter = Counter::callgrind, .instructions = 61234, .steps = 50, .steps_alone = true};
  after.instructions = {
      .counter = Counter::callgrind, .instructions = 61235, .steps = 50, .steps_alone = true};
  const auto worst = [&] {
    results::Comparison row;
    row.metrics = compare_profiles(before, after);
    return results::worst_finding(row);
  };
  EXPECT_EQ(worst(), Finding::changed);
  after.instructions.steps_alone = false;  // what the worker prints is counted too
  EXPECT_EQ(worst(), Finding::same);
  after.instructions = {
      .counter = Counter::perf_event, .instructions = 99999, .steps = 50, .steps_alone = false};
  EXPECT_EQ(worst(), Finding::same);
}

// ---- Reports -----------------------------------------------------------------------------------------

results::Comparison with_time(Finding finding, double ratio, double p) {
  results::Comparison c;
  c.time.emplace();
  c.time->finding = finding, c.time->ratio = ratio, c.time->p = p;
  return c;
}

TEST(Gate, HolmConfirmsWeakerRegressionsOnlyAfterStronger) {
  // alpha = 0.01, m = 3: 0.002 x 3 and 0.004 x 2 are confirmed, 0.02 is not.
  std::vector<results::Comparison> cells = {with_time(Finding::inconclusive, 1.04, 0.004),
                                            with_time(Finding::regressed, 1.09, 0.002),
                                            with_time(Finding::inconclusive, 1.03, 0.02)};
  adjust(cells, 0.01);
  EXPECT_EQ(cells[0].time->finding, Finding::regressed);
  EXPECT_EQ(cells[1].time->finding, Finding::regressed);
  EXPECT_EQ(cells[2].time->finding, Finding::inconclusive);
  EXPECT_NEAR(cells[0].time->adjusted, 0.008, 1e-15);
  std::vector<results::Comparison> faster = {with_time(Finding::inconclusive, 0.9, 0.001)};
  adjust(faster, 0.01);
  EXPECT_EQ(faster[0].time->finding, Finding::improved);
}

// A baseline that alternates between two speeds with the order of the pairs is told from itself.
TEST(SelfCheck, UnreliableEnvironmentGivesNoTimes) {
  int taken = 0;
  const auto alternating = [&] {
    const int pair = taken / 2, place = taken++ % 2;
    const bool second = (place == 0) != first_goes_first(pair);
    return Sample{(second ? 1.15 : 1) * (2e-3 + 1e-7 * (taken % 5)), ""};
  };
  PairedTimes same(alternating, alternating, {});
  while (same.wants_more()) same.take_pair();
  results::ComparisonReport report;
  report.self_check = same.summary();
  ASSERT_EQ(report.self_check->finding, Finding::regressed);
  report.cells = {with_time(Finding::regressed, 1.2, 1e-4), with_time(Finding::same, 1, 1)};
  report.cells[1].metrics = {{"error of position", Finding::regressed, "rose"}};
  conclude(report);
  EXPECT_FALSE(report.reliable);
  EXPECT_EQ(report.cells[0].finding, Finding::inconclusive);
  EXPECT_EQ(report.cells[1].finding, Finding::regressed);  // results do not depend on the machine
  report.self_check->finding = Finding::same;
  report.cells[0].time->finding = Finding::regressed, report.cells[0].finding = Finding::same;
  report.reliable = true;
  conclude(report);
  EXPECT_TRUE(report.reliable);
  EXPECT_EQ(report.cells[0].finding, Finding::regressed);
}

// ---- Whole comparisons, without times ----------------------------------------------------------------

class Sides : public testing::Test {
 protected:
  void SetUp() override { scenario = scenario::load(std::string(source_dir) + "/scenarios/projectile.toml"); }

  /// A build folder whose in-house worker is another one of ours, or a script.
  Side side(const std::string& name, const std::string& worker) const {
    const fs::path place = folder / name / "cylon-worker-in-house";
    fs::create_directories(place.parent_path());
    if (worker.starts_with("#!")) {
      std::ofstream(place) << worker;
      fs::permissions(place, fs::perms::owner_all);
    } else {
      fs::copy_file(fs::path(binary_dir) / worker, place);
    }
    return {name, process::default_engines(folder / name)};
  }

  results::Comparison compared(const Side& before, const Side& after, bool timed = false) const {
    Cell cell;
    cell.scenario = &scenario;
    cell.engine = process::parse_engine("in-house", process::default_engines(binary_dir));
    cell.dt = scenario.step, cell.dt_text = scenario.step_text;
    CompareOptions options;
    options.time = timed;
    return compare({cell}, before, after, options, {}).cells.at(0);
  }

  const TemporaryFolder own_;
  const fs::path folder = own_.path();
  scenario::Scenario scenario;
};

TEST_F(Sides, SkipsIdenticalBinary) {
  const results::Comparison c =
      compared(side("one", "cylon-worker-in-house"), side("two", "cylon-worker-in-house"));
  EXPECT_EQ(c.finding, Finding::skipped);
  EXPECT_NE(c.reason.find("identical"), std::string::npos) << c.reason;
}

TEST_F(Sides, DetectsLowerAndHigherAccuracy) {
  const Side right = side("right", "cylon-worker-in-house"), wrong = side("wrong", "cylon-worker-bullet-f64");
  const results::Comparison worse = compared(right, wrong), better = compared(wrong, right);
  EXPECT_EQ(worse.finding, Finding::regressed);
  EXPECT_FALSE(worse.metrics.empty());
  EXPECT_EQ(better.finding, Finding::improved);
}

TEST_F(Sides, NewFailureIsRegressionAndMissingIsReported) {
  const Side good = side("good", "cylon-worker-in-house"), dead = side("dead", "#!/bin/sh\nexit 1\n");
  const Side gone = side("gone", "#!/bin/sh\nkill -SEGV $$\n");
  const Side none{"none", process::default_engines(folder / "none")};
  const struct {
    const Side &before, &after;
    Finding finding;
    const char* says;
  } cases[] = {{good, dead, Finding::regressed, "no longer runs: crash"},
               {dead, good, Finding::improved, "the baseline did not run"},
               {dead, gone, Finding::skipped, "neither build runs"},
               {none, good, Finding::skipped, "none has no worker for 'in-house'"},
               {good, none, Finding::regressed, "none no longer has a worker for 'in-house'"}};
  for (const auto& c : cases) {
    const results::Comparison row = compared(c.before, c.after);
    EXPECT_EQ(row.finding, c.finding) << c.says;
    EXPECT_NE(row.reason.find(c.says), std::string::npos) << row.reason;
  }
}

TEST_F(Sides, ContentDecidesEquality) {
  const auto hash = [&](const Side& s) { return content_hash(s.engines.front().command); };
  EXPECT_EQ(hash(side("a", "#!/bin/sh\nexit 1\n")), hash(side("b", "#!/bin/sh\nexit 1\n")));
  EXPECT_NE(hash(side("c", "#!/bin/sh\nexit 1\n")), hash(side("d", "#!/bin/sh\nexit 2\n")));
  EXPECT_NE(content_hash({"mine", "--fast"}), content_hash({"mine", "--slow"}));
  // The workers in Node are links to one script, which reads the engine from their names.
  side("e", "#!/bin/sh\nexit 1\n");
  for (const char* link : {"one", "other"}) fs::create_symlink("e/cylon-worker-in-house", folder / link);
  EXPECT_NE(content_hash({folder / "one"}), content_hash({folder / "other"}));
}

// What starts a worker was taken for the worker: no optional engine had a time, and a gate said that it is the same.
TEST_F(Sides, OptionalWorkerIsHereAlsoWhereAnotherProgramStartsIt) {
  process::EngineChoice engine = process::parse_engine("in-house", process::default_engines(binary_dir));
  engine.row.brought_by = "what brings it";
  const std::string worker = engine.row.command.front();
  const process::EngineChoice one = pinned(engine, {{"taskset", "-c", "0"}, ""});
  EXPECT_EQ(process::command_of(one.row), (std::vector<std::string>{"taskset", "-c", "0", worker}));
  engine.row.command = {"/no/such/worker"};
  EXPECT_THROW(process::command_of(pinned(engine, {{"taskset"}, ""}).row), process::Failure);
}

TEST_F(Sides, TimesOfTwoBuildsAreNotCompared) {
  std::ifstream example(std::string(source_dir) + "/docs/examples/foreign_engine.py");
  const std::string script{std::istreambuf_iterator<char>(example), {}}, version = "\"version\": \"1.0\"";
  ASSERT_NE(script.find(version), std::string::npos);
  const auto versioned = [&](const std::string& text) {
    return std::string(script).replace(script.find(version), version.size(), "\"version\": \"" + text + "\"");
  };
  const Side native = side("native", versioned("1.0")), other = side("other", versioned("1.0 (JavaScript)"));
  const results::Comparison row = compared(native, other, true);
  EXPECT_EQ(row.untimed, "native is native code, other is JavaScript: their costs do not compare");
  EXPECT_EQ(row.finding, Finding::inconclusive);
  EXPECT_FALSE(row.time);
  EXPECT_FALSE(row.metrics.empty());
}

}  // namespace
}  // namespace cylon::study
