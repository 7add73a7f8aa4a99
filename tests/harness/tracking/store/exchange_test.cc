// The history out and in again: JSON Lines without loss, CSV with all samples, Google Benchmark's JSON;
// whatever is malformed is refused with its place, and nothing of it stays.
#include "harness/core/input_error.h"
#include "harness/tracking/store/google_benchmark.h"
#include "harness/tracking/store/json_lines.h"
#include "harness/tracking/store/samples_csv.h"
#include "tests/harness/tracking/store/places.h"

#include <fmt/format.h>

#include <functional>

namespace cylon::store {
namespace {

std::string text_of(const Store& store, void (*write)(const Store&, std::ostream&)) {
  std::ostringstream out;
  write(store, out);
  return out.str();
}

// Strange texts, numbers at the ends of their range, an incomplete run, an anchor and change points.
void fill(Store& store) {
  for (const char* revision : {"v1.0-3-gabc", "=1+2", "naïve, \"two\"\nlines"}) {
    const std::int64_t id = store.begin_run(run(revision));
    for (const char* scenario : {"tumbling", "rolling, \"fast\"", "-minus"}) {
      Result r = result(scenario, 1.0 / 3, {1.0 / 7, 5e-324, 1.7976931348623157e308, -0.125, 3});
      r.samples.push_back({{"undefined", Kind::info, ""}, 0, std::numeric_limits<double>::quiet_NaN(), ""});
      r.samples.push_back({{"instructions", Kind::exact, ""}, 0, 123456789012345, ""});
      store.add(id, r);
    }
    if (*revision == 'v') store.finish_run(id);
  }
  store.pin({"v1", "in-house=anchors/v1", "aa", "2024-05-01T00:00:00Z", "first", ""});
  store.set({"abc/cpu_seconds", "v1", "ignored", "2024-05-02T00:00:00Z", "moved"});
  store.set({"abc/cpu_seconds", "v0", "detected", "2024-05-02T00:00:00Z", ""});
}

class Exchange : public AnyPlace {
 protected:
  Store fresh(const std::string& name) const { return Store::open(AnyPlace::fresh(name), Mode::write); }
};
IN_ALL_PLACES(Exchange);

TEST_P(Exchange, OfJsonLinesIsTheSameBytesAgain) {
  Store first = fresh("a"), second = fresh("b");
  fill(first);
  const std::string lines = text_of(first, write_json_lines);
  const Imported imported = read_json_lines(second, lines, "a.jsonl");
  EXPECT_EQ(imported.runs, 3u);
  EXPECT_EQ(imported.results, 9u);
  EXPECT_EQ(text_of(second, write_json_lines), lines);
  EXPECT_TRUE(second.check().empty());
}

// A history moves between a file and a server without loss.
TEST_P(Exchange, IsTheSameFromAFileAndFromAServer) {
  Store any = fresh("a"), local = Store::open(folder / "file.db", Mode::write);
  fill(local);
  const std::string lines = text_of(local, write_json_lines);
  read_json_lines(any, lines, "file.jsonl");
  EXPECT_EQ(text_of(any, write_json_lines), lines);
  EXPECT_EQ(text_of(any, write_samples_csv), text_of(local, write_samples_csv));
}

TEST_P(Exchange, RepeatedImportAddsNothing) {
  Store store = fresh("a");
  fill(store);
  const std::string lines = text_of(store, write_json_lines);
  const Imported again = read_json_lines(store, lines, "a.jsonl");
  EXPECT_EQ(again.runs + again.results, 0u);
  EXPECT_EQ(again.here_already, 9u);
  EXPECT_EQ(text_of(store, write_json_lines), lines);
}

// What two machines recorded of two revisions becomes one history.
TEST_P(Exchange, MergesTheHistoriesOfSeveralMachines) {
  Store here = fresh("a"), there = fresh("b");
  const auto record = [](Store& store, const char* revision, std::int64_t order, double seconds) {
    RunInfo r = run(revision);
    r.revision_order = order;
    const std::int64_t id = store.begin_run(r);
    store.add(id, result("tumbling", 0.0125, {seconds}));
  };
  record(here, "r1", 1, 0.1), record(here, "r3", 3, 0.3);
  record(there, "r2", 2, 0.2);
  read_json_lines(here, text_of(there, write_json_lines), "b.jsonl");
  const std::vector<Series> series = here.series("*", "cpu_seconds");
  std::vector<double> values;
  for (const Point& point : series.at(0).points) values.push_back(point.values.at(0));
  EXPECT_EQ(values, (std::vector<double>{0.1, 0.2, 0.3}));
}

TEST_P(Exchange, KeepsTheLaterStateOfAChangePoint) {
  Store here = fresh("a"), there = fresh("b");
  here.set({"s/t", "r2", "ignored", "2024-05-03T00:00:00Z", "later"});
  here.set({"s/t", "r3", "detected", "2024-05-01T00:00:00Z", "earlier"});
  there.set({"s/t", "r2", "detected", "2024-05-02T00:00:00Z", ""});
  there.set({"s/t", "r3", "fixed", "2024-05-02T00:00:00Z", ""});
  read_json_lines(here, text_of(there, write_json_lines), "b.jsonl");
  EXPECT_EQ(here.change_points().at(0).state, "ignored");
  EXPECT_EQ(here.change_points().at(1).state, "fixed");
}

TEST_P(Exchange, OfCsvKeepsEverySample) {
  Store first = fresh("a"), second = fresh("b");
  fill(first);
  const std::string csv = text_of(first, write_samples_csv);
  EXPECT_NE(csv.find(",'=1+2,"), std::string::npos) << "a formula";
  EXPECT_NE(csv.find(",-0.125,"), std::string::npos) << "a number is no formula";
  read_samples_csv(second, csv, "a.csv");
  EXPECT_EQ(text_of(second, write_samples_csv), csv);
  const Imported again = read_samples_csv(second, csv, "a.csv");
  EXPECT_EQ(again.runs + again.results, 0u);
}

TEST_P(Exchange, TakesCsvThatIsWrittenByHand) {
  Store store = fresh("a");
  const char* csv =
      "engine,scenario,revision,metric,kind,unit,repetition,value\n"
      "mine,fall,1.0,frame,time,s,0,0.25\n"
      "mine,fall,1.0,frame,time,s,1,0.5\n"
      "mine,\"fall, long\",2.0,frame,time,s,0,-3e-2\n";
  read_samples_csv(store, csv, "mine.csv");
  ASSERT_EQ(store.runs().size(), 2u);
  EXPECT_EQ(store.series("fall/mine", "frame").at(0).points.at(0).values, (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(store.series("fall, long/mine", "*").at(0).points.at(0).values, (std::vector<double>{-0.03}));
}

constexpr const char* benchmark = R"({
  "context": {"date": "2024-05-01T10:00:00+00:00", "host_name": "box", "executable": "./build/pile_bench",
              "num_cpus": 4, "mhz_per_cpu": 2500, "caches": [], "load_avg": [1.5], "library_build_type": "release"},
  "benchmarks": [
    {"name": "pile/100", "run_name": "pile/100", "run_type": "iteration", "repetitions": 2, "repetition_index": 0,
     "threads": 1, "iterations": 30, "real_time": 2.5, "cpu_time": 2.25, "time_unit": "ms", "contacts": 321.5},
    {"name": "pile/100", "run_name": "pile/100", "run_type": "iteration", "repetitions": 2, "repetition_index": 1,
     "threads": 1, "iterations": 30, "real_time": 2.625, "cpu_time": 2.375, "time_unit": "ms", "contacts": 321.5},
    {"name": "pile/100_mean", "run_name": "pile/100", "run_type": "aggregate", "aggregate_name": "mean",
     "iterations": 2, "real_time": 2.5625, "cpu_time": 2.3125, "time_unit": "ms"},
    {"name": "pile/7", "run_name": "pile/7", "run_type": "iteration", "repetition_index": 0, "iterations": 9,
     "error_occurred": true, "error_message": "no worker", "real_time": 0, "cpu_time": 0, "time_unit": "ms"}
  ]})";

TEST_P(Exchange, TakesGoogleBenchmarksAndGivesThemBack) {
  Store store = fresh("a");
  RunInfo given = run("r9");
  given.date = given.machine = "";
  const Imported imported = read_google_benchmark(store, benchmark, "b.json", given);
  EXPECT_EQ(imported.results, 2u);
  EXPECT_EQ(store.runs().at(0).date, "2024-05-01T10:00:00+00:00");
  EXPECT_EQ(store.runs().at(0).machine, "box, 4 logical CPUs, 2500 MHz");
  const auto cpu = store.series("pile/100/pile_bench", "cpu_time").at(0).points.at(0).values;
  ASSERT_EQ(cpu.size(), 2u);
  EXPECT_DOUBLE_EQ(cpu[0], 2.25e-3);
  EXPECT_DOUBLE_EQ(cpu[1], 2.375e-3);
  EXPECT_EQ(store.series("*", "contacts").at(0).points.at(0).values, (std::vector<double>{321.5, 321.5}));
  EXPECT_EQ(store.series("*", "contacts").at(0).metric.kind, Kind::info);
  const auto results = store.results(1);
  EXPECT_TRUE(std::any_of(results.begin(), results.end(), [](const Result& r) {
    return r.judgements.size() == 1 && r.judgements[0].status == "fail" &&
           r.judgements[0].detail == "no worker";
  }));

  std::ostringstream out;
  write_google_benchmark(store, store.runs().at(0), out);
  Store second = fresh("b");
  read_google_benchmark(second, out.str(), "again.json", run("r9"));
  const auto again = second.series("pile/100/*", "cpu_time").at(0).points.at(0).values;
  ASSERT_EQ(again.size(), 2u);
  EXPECT_DOUBLE_EQ(again[1], 2.375e-3);
  EXPECT_EQ(read_google_benchmark(store, benchmark, "b.json", given).results, 0u);
}

struct Bad {
  const char* what;
  std::string text;
  const char* said;  // place, key and value
};

// Reads each into a store that holds something, and expects the sentence and the store as it was.
void expect_refused(Store& store, const std::vector<Bad>& table,
                    const std::function<void(const std::string&)>& read) {
  const std::string before = text_of(store, write_json_lines);
  for (const Bad& bad : table) {
    try {
      read(bad.text);
      ADD_FAILURE() << bad.what << " was taken";
    } catch (const core::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(bad.said), std::string::npos)
          << bad.what << ": " << error.what();
    }
    EXPECT_TRUE(text_of(store, write_json_lines) == before) << bad.what << " left something";
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.rfind(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST_P(Exchange, RefusesMalformedJsonLinesWhole) {
  Store other = fresh("b"), store = fresh("a");
  const std::int64_t id = other.begin_run(run("r1"));
  other.add(id, result("tumbling", 0.0125, {1}));
  const std::string good = text_of(other, write_json_lines);  // header, cell, run, result
  fill(store);
  expect_refused(
      store,
      {{"a cut line", good.substr(0, good.size() - 20), "x.jsonl:4:"},
       {"no header", good.substr(good.find('\n') + 1), "x.jsonl:1:1: the first line must be"},
       {"a later version", replaced(good, "\"cylon_history\":1", "\"cylon_history\":2"), "is version 2"},
       {"an unknown key", replaced(good, "\"asked\"", "\"aksed\""),
        "x.jsonl:4:1: result: \"asked\" is missing"},
       {"a further key", replaced(good, "\"asked\"", "\"more\":1,\"asked\""), "\"more\" is no key"},
       {"a text for a number", replaced(good, "\"repetition\":0", "\"repetition\":\"0\""),
        "x.jsonl:4:1: sample: \"repetition\" must be a whole number >= 0, not \"0\""},
       {"a negative repetition", replaced(good, "\"repetition\":0", "\"repetition\":-1"), "not -1"},
       {"an unknown kind", replaced(good, "\"kind\":\"time\"", "\"kind\":\"tyme\""), "'tyme' is none of"},
       {"a wrong hash", replaced(good, "\"dt\":0.0125", "\"dt\":0.0126"), "x.jsonl:2:1: cell: \"hash\""},
       {"a run that is not there", replaced(good, "{\"result\":{\"run\":\"", "{\"result\":{\"run\":\"f"),
        "is not defined above"},
       {"a number out of range", replaced(good, "\"truth_error\":1e-13", "\"truth_error\":1e999"),
        "x.jsonl:4:"},
       {"a sample twice",
        replaced(good, "\"samples\":[",
                 "\"samples\":[{\"metric\":\"cpu_seconds\",\"kind\":\"time\",\"unit\":\"s\",\"repetition\":0,"
                 "\"value\":1},"),
        "metric cpu_seconds, repetition 0 stands twice"},
       {"other values of a result that is there",
        good + replaced(good.substr(good.rfind("{\"result\"")), "1e-13", "2e-13"),
        "x.jsonl:5:1: result: \"cell\""},
       {"another key", good + "{\"runn\":{}}\n", "x.jsonl:5:1: unknown key 'runn', did you mean 'run'?"}},
      [&](const std::string& text) { read_json_lines(store, text, "x.jsonl"); });
}

TEST_P(Exchange, RefusesMalformedCsvWhole) {
  Store store = fresh("a");
  fill(store);
  const std::string head = "revision,scenario,engine,metric,kind,repetition,value\n",
                    good = "1,fall,mine,m,time,0,2\n";
  expect_refused(
      store,
      {{"nothing", "", "is empty"},
       {"an unknown column", "revison" + head.substr(8) + good, "unknown column 'revison', did you mean"},
       {"a missing column", "revision,scenario,engine,metric,value\n", "no column 'kind'"},
       {"a missing field", head + good + "1,fall,mine,m,time,0\n", "x.csv:3:1: 6 fields"},
       {"no number", head + good + "1,fall,mine,m,time,1,fast\n", "x.csv:3:1: column value: 'fast'"},
       {"no finite number", head + "1,fall,mine,m,time,1,inf\n", "column value: 'inf'"},
       {"no kind", head + good + "1,fall,mine,m,times,1,3\n", "column kind: 'times'"},
       {"no scenario", head + good + "1,,mine,m,time,1,3\n", "column scenario: ''"},
       {"a repetition twice", head + good + good, "stands twice"},
       {"a quote that does not end", head + "\"1,fall\n", "does not end"}},
      [&](const std::string& text) { read_samples_csv(store, text, "x.csv"); });
}

TEST_P(Exchange, RefusesMalformedBenchmarksWhole) {
  Store store = fresh("a");
  fill(store);
  expect_refused(
      store,
      {{"no JSON", std::string(benchmark).substr(0, 300), "x.json:"},
       {"no context", "{\"benchmarks\": []}", "\"context\" is missing"},
       {"a unit",
        replaced(benchmark, "\"time_unit\": \"ms\", \"contacts\"", "\"time_unit\": \"h\", \"contacts\""),
        "benchmark 2: \"time_unit\" 'h' is none of"},
       {"no time", replaced(benchmark, "\"cpu_time\": 2.375", "\"cpu_tame\": 2.375"),
        "benchmark 2: \"cpu_time\" is missing"},
       {"processors without a number",
        R"({"context": {"date": "d", "executable": "e", "num_cpus": null}, "benchmarks": []})",
        "\"num_cpus\" must be a whole number >= 0, not null"},
       {"a repetition twice", replaced(benchmark, "\"repetition_index\": 1", "\"repetition_index\": 0"),
        "stands twice"},
       {"aggregates alone",
        "{\"context\":{\"date\":\"d\",\"executable\":\"e\"},\"benchmarks\":[{\"name\":\"a\",\"run_type\":"
        "\"aggregate\"}]}",
        "aggregates alone"}},
      [&](const std::string& text) { read_google_benchmark(store, text, "x.json", run("r1")); });
}

}  // namespace
}  // namespace cylon::store
