// Steps injected into a stored history are found at their revision, in ratios and not in times.
#include "harness/tracking/statistics/change_points.h"
#include "harness/tracking/track_history_rows.h"
#include "harness/tracking/track_history_text.h"
#include "tests/harness/cli/fixture.h"
#include "tests/harness/tracking/history_fixture.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace cylon::tracking {

using namespace cli;
namespace {

class History : public CommandLine {
 protected:
  std::filesystem::path file() const { return folder / "history.db"; }

  HistoryRow row(const std::string& engine, const std::string& metric) const {
    const auto rows =
        history_rows(store::Store::open(file(), store::Mode::read), {.engine = engine, .metric = metric});
    EXPECT_EQ(rows.size(), 1U) << engine << " " << metric;
    return rows.empty() ? HistoryRow{} : rows.front();
  }
};

std::vector<std::string> changed_at(const HistoryRow& row) {
  std::vector<std::string> at;
  for (const HistoryChange& change : row.changes) at.push_back(row.points[change.index].revision);
  return at;
}

struct Injected {
  std::vector<Step> steps;
  std::uint64_t seed;
};

class HistorySteps : public History, public testing::WithParamInterface<Injected> {};

TEST_P(HistorySteps, AreFoundAtTheirRevision) {
  make_up(file(), {.steps = GetParam().steps, .seed = GetParam().seed});
  const HistoryRow found = row("in-house", "cpu_ratio:*");
  EXPECT_EQ(found.scale, Scale::ratio);
  std::vector<std::string> expected;
  for (const Step& step : GetParam().steps) expected.push_back(revision(step.at));
  ASSERT_EQ(changed_at(found), expected);
  for (std::size_t i = 0; i < found.changes.size(); ++i) {
    const HistoryChange& change = found.changes[i];
    const double factor = GetParam().steps[i].factor;
    EXPECT_EQ(change.outcome, factor > 1 ? statistics::Outcome::regressed : statistics::Outcome::improved);
    // Some ten ratios on either side, each of 16 pairs that stray by 1.4 %: 0.16 %, and four of it.
    EXPECT_NEAR(*change.ratio, factor, 0.0065);
    EXPECT_EQ(change.state, "detected");
  }
  // The negative control: the same runs without their anchor.  The machine's own steps are all over the
  // place.
  std::vector<double> times;
  for (const store::Series& series :
       store::Store::open(file(), store::Mode::read).series("*in-house*", "cpu_seconds"))
    for (const store::Point& point : series.points) times.push_back(std::log(point.values.front()));
  std::vector<std::string> in_times;
  for (const auto& point : statistics::change_points(times)) in_times.push_back(revision(point.index));
  EXPECT_NE(in_times, expected);
  // And bullet, which nobody changed, has none.
  EXPECT_TRUE(row("bullet", "cpu_ratio:*").changes.empty());
}

INSTANTIATE_TEST_SUITE_P(Injected, HistorySteps,
                         testing::Values(Injected{{{23, 1.03}}, 1}, Injected{{{23, 1.05}}, 2},
                                         Injected{{{41, 1.10}}, 3}, Injected{{{12, 1 / 1.05}}, 4},
                                         Injected{{{15, 1.03}, {30, 1.05}, {45, 1.10}}, 5},
                                         Injected{{{20, 1.10}, {40, 1 / 1.10}}, 6}));

// The six columns that a CSV needs leave the unit out, and such ratios were not looked at.
TEST_F(History, RatiosOfACsvWithoutUnitsAreRatios) {
  std::string csv = "revision,scenario,engine,metric,kind,repetition,value\n";
  for (int r = 0; r < 20; ++r)
    for (int k = 0; k < 8; ++k)
      csv += fmt::format("r{:02},drop,e,cpu_ratio:v1,time,{},{}\n", r, k,
                         (r < 10 ? 1.2 : 1.32) + 1e-3 * ((7 * r + 3 * k) % 5));
  write("h.csv", csv);
  ASSERT_EQ(cylon("track import h.csv --store history.db").code, 0);
  const HistoryRow found = row("e", "cpu_ratio:*");
  EXPECT_EQ(found.scale, Scale::ratio);
  EXPECT_EQ(changed_at(found), std::vector<std::string>{"r10"});
}

TEST_F(History, FlatHistoriesHaveNoChange) {
  for (std::uint64_t seed = 11; seed < 15; ++seed) {
    std::filesystem::remove(file());
    make_up(file(), {.revisions = 100, .seed = seed, .pairs = 10});
    for (const HistoryRow& one : history_rows(store::Store::open(file(), store::Mode::read)))
      EXPECT_TRUE(one.changes.empty() && one.versions.empty()) << one.cell.name() << " " << one.metric.name;
  }
}

TEST_F(History, ShowsAccuracyAndVersionsWithSpeed) {
  make_up(file(), {.revisions = 30, .version_at = 17, .error_at = 21});
  const HistoryRow error = row("in-house", "error:*"), hash = row("in-house", "state_hash");
  EXPECT_EQ(changed_at(error), (std::vector<std::string>{"rev021"}));
  EXPECT_EQ(error.changes.at(0).outcome, statistics::Outcome::regressed);
  EXPECT_EQ(error.changes.at(0).sentence, "error rose by 20 %, from 3.1e-06 to 3.72e-06");
  EXPECT_EQ(changed_at(hash), (std::vector<std::string>{"rev021"}));
  const HistoryRow bullet = row("bullet", "error:*");
  EXPECT_EQ(bullet.versions, (std::vector<std::size_t>{17}));
  EXPECT_EQ(bullet.changes.at(0).sentence,
            "error fell by 50 %, from 0.002 to 0.001; engine version 3.24 -> 3.25");
  EXPECT_TRUE(row("in-house", "cpu_ratio:*").versions.empty());

  const Ran page = cylon("track history --store history.db");
  EXPECT_EQ(page.code, 0) << page.err;
  for (const char* part : {"bounce/in-house@0.001\n", "cpu_ratio:base", "error:position", "state_hash",
                           "engine version 3.24 -> 3.25 at rev017", "aaaaaaaaaaaaaaaaaaaaabbbbbbbbb",
                           "error rose by 20 %", "changes: 3 detected"})
    EXPECT_NE(page.out.find(part), std::string::npos) << part << "\n" << page.out;
  EXPECT_LT(page.out.find("cpu_ratio:base"), page.out.find("error:position"));  // speed, then accuracy
  const Ran some = cylon("track history --store history.db --changes --engine in-house");
  EXPECT_EQ(some.out.find("cpu_"), std::string::npos) << some.out;
  EXPECT_NE(some.out.find("changes: 2 detected"), std::string::npos) << some.out;
}

TEST_F(History, JsonHasEveryPoint) {
  make_up(file(), {.revisions = 24, .steps = {{12, 1.1}}});
  const Ran ran = cylon(
      "track history --store history.db --json --metric 'cpu_ratio:*' --scenario 'b*' --engine in-house");
  EXPECT_EQ(ran.code, 0) << ran.err;
  const auto page = nlohmann::json::parse(ran.out);
  ASSERT_EQ(page["series"].size(), 1U);
  const auto& series = page["series"][0];
  EXPECT_EQ(series["scale"], "ratio");
  EXPECT_EQ(series["points"].size(), 24U);
  EXPECT_EQ(series["points"][3]["revision"], "rev003");
  ASSERT_EQ(series["changes"].size(), 1U);
  EXPECT_EQ(series["changes"][0]["revision"], "rev012");
  EXPECT_EQ(series["changes"][0]["index"], 12);
  EXPECT_NEAR(series["changes"][0]["ratio"], 1.1, 0.0065);
  EXPECT_EQ(series["changes"][0]["id"], change_id(series["series"], "rev012"));
  EXPECT_EQ(
      cylon(
          "track history --store history.db --json --metric 'cpu_ratio:*' --scenario 'b*' --engine in-house")
          .out,
      ran.out);
}

// States and notes are kept with the series and the revision, so they outlive further runs.
TEST_F(History, StatesSurvive) {
  make_up(file(), {.revisions = 30, .steps = {{10, 1.10}, {20, 1.05}}});
  const HistoryRow before = row("in-house", "cpu_ratio:*");
  ASSERT_EQ(before.changes.size(), 2U);
  const std::string first = before.changes[0].id, second = before.changes[1].id;
  Ran ran = cylon("track ack " + first + " --note 'exact friction' --store history.db");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out, first + " active: bounce/in-house@0.001 cpu_ratio:base at rev010\n");
  EXPECT_EQ(cylon("track ignore " + second + " --store history.db").code, 0);
  {
    store::Store store = store::Store::open(file(), store::Mode::write);
    store::RunInfo info;
    info.revision = "later";
    store.finish_run(store.begin_run(info));
  }
  HistoryRow after = row("in-house", "cpu_ratio:*");
  ASSERT_EQ(after.changes.size(), 2U);
  EXPECT_EQ(after.changes[0].state, "active");
  EXPECT_EQ(after.changes[0].note, "exact friction");
  EXPECT_EQ(after.changes[1].state, "ignored");
  const Ran page = cylon("track history --store history.db");
  EXPECT_NE(page.out.find("[active] exact friction"), std::string::npos) << page.out;
  EXPECT_NE(page.out.find("changes: 1 active, 1 ignored"), std::string::npos) << page.out;
  // A note stays where no other is given.
  EXPECT_EQ(cylon("track ack " + first + " --fixed --store history.db").code, 0);
  after = row("in-house", "cpu_ratio:*");
  EXPECT_EQ(after.changes[0].state, "fixed");
  EXPECT_EQ(after.changes[0].note, "exact friction");
}

TEST_F(History, RejectsUnknownNames) {
  make_up(file(), {.revisions = 24, .steps = {{12, 1.1}}});
  const std::string id = row("in-house", "cpu_ratio:*").changes.at(0).id;
  std::string near = id;
  near[3] = near[3] == '0' ? '1' : '0';
  struct Row {
    std::string arguments;
    int code;
    std::string says;
  };
  const Row rows[] = {
      {"ack " + near, 2, "did you mean '" + id + "'?"},
      {"ignore " + near, 2, "did you mean '" + id + "'?"},
      {"ack", 2, "id is missing"},
      {"history --metric cpu_secnds", 4,
       "no metric 'cpu_secnds' in the history, did you mean 'cpu_seconds'?"},
      {"history --scenario bonce", 4, "no scenario 'bonce' in the history, did you mean 'bounce'?"},
      {"history --engine odd", 4, "no engine 'odd' in the history"},
  };
  for (const Row& one : rows) {
    const Ran ran = cylon("track " + one.arguments + " --store history.db");
    EXPECT_EQ(ran.code, one.code) << one.arguments << ran.err;
    EXPECT_NE(ran.err.find(one.says), std::string::npos) << one.arguments << "\n" << ran.err;
  }
  const Ran none = cylon("track history --store nowhere.db");
  EXPECT_EQ(none.code, 2);
  // One id that is wrong keeps the others as they were.
  EXPECT_EQ(cylon("track ack " + id + " " + near + " --store history.db").code, 2);
  EXPECT_EQ(row("in-house", "cpu_ratio:*").changes.at(0).state, "detected");
}

// A change that somebody acknowledged and that later runs take away is not forgotten.
TEST_F(History, ReportsAcknowledgedChangeThatVanished) {
  make_up(file(), {.revisions = 24});
  {
    store::Store store = store::Store::open(file(), store::Mode::write);
    store.set({.series = row("in-house", "cpu_ratio:*").series,
               .revision = "rev007",
               .state = "active",
               .date = "2024-05-09",
               .note = "seen by eye"});
  }
  const HistoryRow found = row("in-house", "cpu_ratio:*");
  ASSERT_EQ(found.changes.size(), 1U);
  EXPECT_FALSE(found.changes[0].found);
  EXPECT_EQ(found.changes[0].note, "seen by eye");
  EXPECT_EQ(found.changes[0].sentence, "no longer seen");
}

}  // namespace
}  // namespace cylon::tracking
