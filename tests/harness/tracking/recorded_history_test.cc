// A history that was really recorded (record_steps.sh), on two processors with a load of 17 to 22: the
// in-house engine on dzhanibekov, 42 revisions, of which r07 to r12 are slower by 3 %, r19 to r24 by 5 %, r31
// to r36 by 10 %.
#include "harness/tracking/store/json_lines.h"
#include "harness/tracking/track_history_rows.h"
#include "tests/harness/cli/fixture.h"
#include "tests/paths.h"

namespace cylon::tracking {

using namespace cli;
namespace {

class RecordedHistory : public CommandLine {};

TEST_F(RecordedHistory, ChangePointsAreAtTheirRevisionOnly) {
  const std::filesystem::path data = std::filesystem::path(source_dir) / "tests/data/tracking/steps.jsonl";
  store::Store store = store::Store::open(folder / "history.db", store::Mode::write);
  ASSERT_EQ(store::read_json_lines(store, read(data), data.string()).runs, 42U);

  struct Step {
    const char* revision;
    double factor;
  };
  const Step injected[] = {{"r07", 1.03},     {"r13", 1 / 1.03}, {"r19", 1.05},
                           {"r25", 1 / 1.05}, {"r31", 1.10},     {"r37", 1 / 1.10}};
  std::size_t ratios = 0;
  for (const HistoryRow& row : history_rows(store)) {
    if (row.scale != Scale::ratio) {
      // Slower and no less accurate: neither errors nor hashes nor memory change.
      EXPECT_TRUE(row.changes.empty()) << row.metric.name << ": " << row.changes.front().sentence;
      continue;
    }
    ++ratios;
    ASSERT_EQ(row.points.size(), 42U);
    ASSERT_EQ(row.changes.size(), std::size(injected));
    for (std::size_t i = 0; i < std::size(injected); ++i) {
      EXPECT_EQ(row.points[row.changes[i].index].revision, injected[i].revision);
      EXPECT_GT(injected[i].factor, row.changes[i].interval.low) << injected[i].revision;
      EXPECT_LT(injected[i].factor, row.changes[i].interval.high) << injected[i].revision;
      std::printf("[ measured ] %s: injected x %.4f, found x %.4f\n", injected[i].revision,
                  injected[i].factor, *row.changes[i].ratio);
    }
  }
  EXPECT_EQ(ratios, 1U);
}

TEST_F(RecordedHistory, OnTheCommandLine) {
  const std::string data = std::string(source_dir) + "/tests/data/tracking/steps.jsonl";
  EXPECT_EQ(cylon("track import '" + data + "' --store history.db").code, 0);
  const Ran page = cylon("track history --store history.db --changes");
  EXPECT_EQ(page.code, 0) << page.err;
  EXPECT_NE(page.out.find("changes: 6 detected"), std::string::npos) << page.out;
  EXPECT_NE(page.out.find(" at r31: slower by "), std::string::npos) << page.out;
}

}  // namespace
}  // namespace cylon::tracking
