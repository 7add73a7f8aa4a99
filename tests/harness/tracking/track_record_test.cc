// The data that a recording stores for a cell, read back from the store.
#include "harness/tracking/store/store.h"
#include "tests/harness/cli/fixture.h"

#include <cmath>

namespace cylon::store {
namespace {

class Recorded : public cli::CommandLine {
 protected:
  std::vector<double> values(const Store& store, const std::string& cell, const std::string& metric) const {
    const auto series = store.series(cell, metric);
    EXPECT_EQ(series.size(), 1u) << cell << " " << metric;
    return series.size() == 1 ? series[0].points.back().values : std::vector<double>{};
  }
};

TEST_F(Recorded, CellsHaveErrorsOrdersHashesTimesAndMemory) {
  const cli::Ran ran = cylon(
      "track record spring_orbit --engine in-house --integrator velocity-verlet --integrator rk4 --dt 1/500 "
      "--orders "
      "--repetitions 3 --label first --revision r7 --order 7 --store h.db");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const Store store = Store::open(folder / "h.db", Mode::read);
  const RunInfo run = store.runs().at(0);
  EXPECT_EQ(run.label + run.revision, "firstr7");
  EXPECT_EQ(run.revision_order, 7);
  EXPECT_FALSE(run.machine.empty() || run.compiler.empty() || run.build.empty() || run.date.empty());
  const std::string verlet = "spring_orbit/*velocity-verlet@1/500", rk4 = "spring_orbit/*rk4@1/500";
  // The order of an integrator is what it declares, to what the leading term leaves.
  EXPECT_NEAR(values(store, verlet, "order:position follows*").at(0), 2, 0.2);
  EXPECT_NEAR(values(store, rk4, "order:position follows*").at(0), 4, 0.2);
  const auto seconds = values(store, rk4, "cpu_seconds");
  ASSERT_EQ(seconds.size(), 3u);
  for (const double s : seconds) EXPECT_TRUE(s > 0 && s < 1) << s;
  const double memory = values(store, rk4, "peak_memory").at(0);
  EXPECT_TRUE(memory > 1e6 && memory < 1e9) << memory;
  EXPECT_EQ(store.series(rk4, "state_hash").at(0).points.at(0).text.size(), 16u);
  EXPECT_NE(store.series(rk4, "state_hash").at(0).points.at(0).text,
            store.series(verlet, "state_hash").at(0).points.at(0).text);
  for (const Result& result : store.results(run.id)) {
    EXPECT_GE(result.judgements.size(), 3u);
    for (const Judgement& j : result.judgements) {
      const auto errors = values(store, result.cell.name(), "error:" + j.claim);
      EXPECT_EQ(errors.at(0), j.measured);
    }
  }
}

// The same binary beside itself costs the same, as near as a busy machine tells.
TEST_F(Recorded, TimesAreRelativeToPinnedBinary) {
  ASSERT_EQ(cylon("track pin v1 --engine in-house --store h.db").code, 0);
  const cli::Ran ran = cylon("track record spring_orbit --engine in-house --repetitions 4 --store h.db");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto ratios = values(Store::open(folder / "h.db", Mode::read), "*", "cpu_ratio:v1");
  ASSERT_EQ(ratios.size(), 4u);
  for (const double ratio : ratios) EXPECT_TRUE(ratio > 0.2 && ratio < 5) << ratio;  // a busy machine

  std::ofstream(folder / "anchors/v1-cylon-worker-in-house", std::ios::app) << "changed";
  const cli::Ran changed = cylon("track record spring_orbit --engine in-house --store h.db");
  EXPECT_EQ(changed.code, 2);
  EXPECT_NE(changed.err.find("'v1' is gone or changed"), std::string::npos) << changed.err;
}

// A worker that needs files beside it, as those in Node do, was pinned, and every recording went on without its times.
TEST_F(Recorded, AnchorThatDoesNotStartIsNotPinned) {
  ASSERT_EQ(cylon("track pin v1 --engine in-house --store h.db").code, 0);
  write("alone.sh", "#!/bin/sh\n[ -e \"$(dirname \"$0\")/beside\" ] && exec cylon-worker-in-house\nexit 1\n");
  const cli::Ran pinned =
      shell("chmod +x alone.sh; exec cylon track pin v2 --engine mine --worker mine=./alone.sh --store h.db");
  EXPECT_EQ(pinned.code, 2) << pinned.out;
  EXPECT_NE(pinned.err.find("the copy of the worker does not start"), std::string::npos) << pinned.err;
  EXPECT_EQ(Store::open(folder / "h.db", Mode::read).anchors().size(), 1u);
  EXPECT_FALSE(std::filesystem::exists(folder / "anchors/v2-alone.sh.new"));
}

TEST_F(Recorded, StoresVerdictOfCrashedEngine) {
  write("broken.sh", "#!/bin/sh\nexit 3\n");
  const cli::Ran ran = shell(
      "chmod +x broken.sh; exec cylon track record projectile --engine mine --worker mine=./broken.sh "
      "--store h.db");
  EXPECT_EQ(ran.code, 5) << ran.err;
  const auto results = Store::open(folder / "h.db", Mode::read).results(1);
  ASSERT_EQ(results.size(), 1u);
  ASSERT_FALSE(results[0].judgements.empty());
  EXPECT_EQ(results[0].judgements[0].status, "crash");
  EXPECT_NE(results[0].judgements[0].detail.find("exited 3"), std::string::npos);
  EXPECT_TRUE(results[0].samples.empty());
}

TEST_F(Recorded, OneCellIsNoCells) {
  const auto recorded = cylon("track record projectile --engine in-house --repetitions 0 --store one.db");
  EXPECT_NE(recorded.out.find(", 1 cell\n"), std::string::npos) << recorded.out << recorded.err;
  const auto checked = cylon("track check --store one.db");
  EXPECT_NE(checked.out.find(": 1 run, 1 cell, sound"), std::string::npos) << checked.out << checked.err;
}

TEST_F(Recorded, HistoryRoundTripsOnCommandLine) {
  ASSERT_EQ(cylon("track record projectile --engine in-house --engine ode --repetitions 2 --store h.db").code,
            0);
  ASSERT_EQ(cylon("track export a.jsonl --store h.db").code, 0);
  ASSERT_EQ(cylon("track import a.jsonl --store b.db").code, 0);
  ASSERT_EQ(cylon("track export b.jsonl --store b.db").code, 0);
  EXPECT_TRUE(read("a.jsonl") == read("b.jsonl"));
  EXPECT_NE(cylon("track import a.jsonl --store b.db").out.find("0 runs and 0 results added, 2 were there"),
            std::string::npos);
  ASSERT_EQ(cylon("track export g.json --format gbench --run 1 --store h.db").code, 0);
  EXPECT_EQ(cylon("track import g.json --revision copied --store g.db").code, 0);
  EXPECT_EQ(cylon("track export x --format gbench --store h.db").code, 2);
  EXPECT_EQ(cylon("track export x --run 1 --store h.db").code, 2);
  EXPECT_EQ(cylon("track list 99 --store h.db").code, 2);
  const cli::Ran list = cylon("track list 1 --store h.db");
  EXPECT_NE(list.out.find("cpu_seconds"), std::string::npos) << list.out;
  EXPECT_NE(cylon("track list --json --store h.db").out.find("\"complete\": true"), std::string::npos);
  EXPECT_EQ(cylon("track check --store h.db").code, 0);
}

}  // namespace
}  // namespace cylon::store
