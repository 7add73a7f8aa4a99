// The store returns what was stored, in the defined order, in this process and in the next.
#include "harness/tracking/store/store.h"

#include "harness/core/input_error.h"
#include "tests/harness/tracking/store/places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::store {
namespace {

class Stores : public AnyPlace {};
IN_ALL_PLACES(Stores);

TEST_P(Stores, GiveBackWhatWasAddedInTheNextProcessToo) {
  const Result given = result("tumbling", 0.0125, {3.5e-4, 3.25e-4});
  std::int64_t id = 0;
  {
    Store store = Store::open(place, Mode::write);
    id = store.begin_run(run("r1"));
    store.add(id, given);
    store.finish_run(id);
  }
  const Store store = Store::open(place, Mode::read);
  const std::vector<RunInfo> runs = store.runs();
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].revision, "r1");
  EXPECT_EQ(runs[0].note, run("r1").note);
  EXPECT_EQ(runs[0].uid.size(), 16u);
  EXPECT_TRUE(runs[0].complete);
  const std::vector<Result> results = store.results(id);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(digest(results[0]), digest(given));
  EXPECT_EQ(results[0].engine_version, "2.1");
  ASSERT_EQ(results[0].samples.size(), given.samples.size());
  EXPECT_EQ(results[0].samples[0].value, 3.5e-4);
  EXPECT_EQ(results[0].judgements.at(0).detail, given.judgements.at(0).detail);
  EXPECT_TRUE(store.check().empty());
}

TEST_P(Stores, OrderASeriesByRevisionThenByRecording) {
  Store store = Store::open(place, Mode::write);
  const auto record = [&](const char* revision, std::optional<std::int64_t> order, double seconds) {
    RunInfo r = run(revision);
    r.revision_order = order;
    const std::int64_t id = store.begin_run(r);
    store.add(id, result("tumbling", 0.0125, {seconds}));
    store.add(id, result("rolling", 0.0125, {2 * seconds}));
  };
  record("late", 40, 4);
  record("early", 10, 1);
  record("early", std::nullopt, 1.5);  // the order of the same revision
  record("last", std::nullopt, 5);     // one more than the highest
  const auto series = store.series("tumbling/*", "cpu_seconds");
  ASSERT_EQ(series.size(), 1u);
  std::vector<std::string> revisions;
  std::vector<double> values;
  for (const Point& point : series[0].points) {
    revisions.push_back(point.revision);
    values.push_back(point.values.at(0));
  }
  EXPECT_EQ(revisions, (std::vector<std::string>{"early", "early", "late", "last"}));
  EXPECT_EQ(values, (std::vector<double>{1, 1.5, 4, 5}));
  EXPECT_EQ(series[0].points.back().revision_order, 41);
  EXPECT_EQ(series[0].points[0].engine_version, "2.1");
  EXPECT_EQ(series[0].id, series_id(series[0].cell, series[0].metric));
  EXPECT_EQ(store.series("*", "cpu_seconds").size(), 2u);
  EXPECT_EQ(store.series("*", "state_hash").at(0).points.at(0).text, "00ff");
  EXPECT_TRUE(store.series("nothing*", "*").empty());
}

TEST_P(Stores, KeepRepetitionsAndNaN) {
  Store store = Store::open(place, Mode::write);
  const std::int64_t id = store.begin_run(run("r1"));
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  store.add(id, result("tumbling", 0.0125, {0.5, nan, inf, 1e-308, -0.0}));
  const auto values = store.series("*", "cpu_seconds").at(0).points.at(0).values;
  ASSERT_EQ(values.size(), 5u);
  EXPECT_EQ(values[0], 0.5);
  EXPECT_TRUE(std::isnan(values[1]) && std::isnan(values[2]));
  EXPECT_EQ(values[3], 1e-308);
  EXPECT_FALSE(std::signbit(values[4]));
  EXPECT_TRUE(store.check().empty());
}

// Another value of any field is another cell; the way in which a step is written is none.
TEST(Cells, AreIdentifiedByContent) {
  const Cell base = result("tumbling", 0.0125, {}).cell;
  const std::string hash = cell_hash(base);
  std::string Cell::*const fields[] = {&Cell::scenario,   &Cell::scenario_hash, &Cell::engine,  &Cell::path,
                                       &Cell::integrator, &Cell::precision,     &Cell::settings};
  for (std::string Cell::*const field : fields) {
    Cell other = base;
    other.*field += "x";
    EXPECT_NE(cell_hash(other), hash);
  }
  Cell other = base;
  other.dt = std::nextafter(base.dt, 1);
  EXPECT_NE(cell_hash(other), hash);
  other = base;
  other.dt_text = "1/80";
  EXPECT_EQ(cell_hash(other), hash);
  Cell moved = base;  // the border between two fields counts
  moved.path = "", moved.engine = base.engine + base.path;
  EXPECT_NE(cell_hash(moved), hash);
}

TEST_P(Stores, IgnoreRepeatedCell) {
  Store store = Store::open(place, Mode::write);
  const std::int64_t id = store.begin_run(run("r1"));
  const Result first = result("tumbling", 0.0125, {1});
  store.add(id, first);
  EXPECT_THROW(store.add(id, result("tumbling", 0.0125, {2})), core::InputError);
  ASSERT_EQ(store.results(id).size(), 1u);
  EXPECT_EQ(digest(store.results(id)[0]), digest(first));
}

TEST_P(Stores, FailedTransactionChangesNothing) {
  Store store = Store::open(place, Mode::write);
  EXPECT_THROW(store.in_one_transaction([&] {
    store.add(store.begin_run(run("r1")), result("tumbling", 0.0125, {1}));
    throw core::InputError("no further");
  }),
               core::InputError);
  EXPECT_TRUE(store.runs().empty());
  EXPECT_TRUE(store.cells().empty());
}

TEST_P(Stores, GiveEqualRunsDifferentIds) {
  Store store = Store::open(place, Mode::write);
  store.begin_run(run("r1"));
  store.begin_run(run("r1"));
  const std::vector<RunInfo> runs = store.runs();
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_NE(runs[0].uid, runs[1].uid);
}

TEST_P(Stores, FindRunByNumberLabelOrRevision) {
  Store store = Store::open(place, Mode::write);
  RunInfo labelled = run("r1");
  labelled.label = "before";
  const std::int64_t first = store.begin_run(labelled);
  labelled.label = "after";
  const std::int64_t second = store.begin_run(labelled);
  const std::string uid = store.find_run("before").value().uid;
  EXPECT_EQ(store.find_run("before").value().id, first);
  EXPECT_EQ(store.find_run("r1").value().id, second);  // the latest of the revision
  EXPECT_EQ(store.find_run(uid).value().id, first);
  EXPECT_EQ(store.find_run(uid.substr(0, 8)).value().id, first);
  EXPECT_EQ(store.find_run("2").value().id, second);
  EXPECT_FALSE(store.find_run("never").has_value());
}

// * ? [a-z] [^…] match as SQLite's GLOB does, and nothing else is special.
TEST_P(Stores, SelectCellsByGlob) {
  Store store = Store::open(place, Mode::write);
  const std::int64_t id = store.begin_run(run("r1"));
  for (const char* scenario :
       {"top_1", "top_2", "top_10", "a.b", "aXb", "a\\b", "a]b", "a[b", "a^b", "(a|b)", "Top_1", "ä"})
    store.add(id, result(scenario, 0.0125, {1}));
  const std::pair<const char*, std::size_t> rows[] = {
      {"*", 12},        {"top_*", 3},     {"top_?/*", 2},        {"a.b/*", 1},    {"a?b/*", 6},
      {"a[.X]b/*", 2},  {"a[^.X]b/*", 4}, {"a[]]b/*", 1},        {"a[^]]b/*", 5}, {"a\\b/*", 1},
      {"a[\\]b/*", 1},  {"a[[]b/*", 1},   {"(a|b)/*", 1},        {"top", 0},      {"[a-t]op_1/*", 1},
      {"?/*", 1},       {"a[b", 0},       {"*[0-9]/bullet*", 4}, {"a^b/*", 1},    {"top+_1/*", 0},
      {"top_1{0}/*", 0}};
  for (const auto& [glob, count] : rows) EXPECT_EQ(store.cells(glob).size(), count) << glob;
}

// Byte by byte, whatever language a server speaks.
TEST_P(Stores, OrderTextsByBytes) {
  Store store = Store::open(place, Mode::write);
  const std::int64_t id = store.begin_run(run("r1"));
  for (const char* scenario : {"b", "B", "a", "A", "ä", "_", "Z", "z", "a b", "ab"})
    store.add(id, result(scenario, 0.0125, {1}));
  std::vector<std::string> names;
  for (const Cell& cell : store.cells()) names.push_back(cell.name());
  EXPECT_EQ(names.size(), 10u);
  EXPECT_TRUE(std::ranges::is_sorted(names));
}

TEST_P(Stores, AreReadWhileAnotherWrites) {
  Store writer = Store::open(place, Mode::write);
  const std::int64_t id = writer.begin_run(run("r1"));
  const Store reader = Store::open(place, Mode::read);
  EXPECT_EQ(reader.runs().size(), 1u);
  writer.add(id, result("tumbling", 0.0125, {1}));
  EXPECT_EQ(reader.results(id).size(), 1u);
}

TEST_P(Stores, ThatAreReadAreNotWritten) {
  EXPECT_THROW(Store::open(place, Mode::read), core::InputError);  // there is none yet
  Store::open(place, Mode::write).begin_run(run("r1"));
  Store store = Store::open(place, Mode::read);
  EXPECT_THROW(store.begin_run(run("r2")), core::InputError);
  EXPECT_EQ(store.runs().size(), 1u);
}

TEST_P(Stores, OfANewerSchemaAreRefused) {
  Store::open(place, Mode::write).begin_run(run("r1"));
  raw(on_server() ? "UPDATE store SET schema = 98" : "PRAGMA user_version = 98");
  for (const Mode mode : {Mode::read, Mode::write}) try {
      Store::open(place, mode);
      ADD_FAILURE();
    } catch (const core::InputError& error) {
      EXPECT_NE(std::string(error.what()).find("newer Cylon (schema 98"), std::string::npos) << error.what();
    }
}

TEST_P(Stores, KeepAnchorsAndChangePointsAndLetThemBeSetAnew) {
  Store store = Store::open(place, Mode::write);
  store.pin({"v1", "bin/cylon", "aa", "2024-05-01T00:00:00Z", "first", ""});
  store.pin({"v1", "bin/cylon-2", "bb", "2024-05-02T00:00:00Z", "again", ""});
  ASSERT_EQ(store.anchors().size(), 1u);
  EXPECT_EQ(store.anchors()[0].binary, "bin/cylon-2");
  store.set({"s/cpu_seconds", "r2", "detected", "2024-05-01T00:00:00Z", ""});
  store.set({"s/cpu_seconds", "r2", "ignored", "2024-05-02T00:00:00Z", "the machine was moved"});
  ASSERT_EQ(store.change_points().size(), 1u);
  EXPECT_EQ(store.change_points()[0].state, "ignored");
  EXPECT_THROW(store.set({"s/cpu_seconds", "r2", "forgotten", "", ""}), core::InputError);
}

TEST_P(Stores, EscapeInvalidBytesOfEngines) {
  Store store = Store::open(place, Mode::write);
  const std::int64_t id = store.begin_run(run("r1"));
  Result given = result("tumbling", 0.0125, {1});
  given.judgements[0].detail = "\x1b[2J\xff" + std::string("a\0b", 3);
  store.add(id, given);
  EXPECT_EQ(store.results(id)[0].judgements[0].detail, "\\x1b[2J\\xffa\\x00b");
  EXPECT_TRUE(store.check().empty());
}

}  // namespace
}  // namespace cylon::store
