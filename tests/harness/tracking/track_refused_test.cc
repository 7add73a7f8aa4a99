// If the history cannot be written, the command prints one sentence with the file and a remedy, exits with 2,
// and leaves the stored data unchanged to the byte.
#include "harness/tracking/store/json_lines.h"
#include "tests/harness/cli/fixture.h"

#include <fmt/format.h>
#include <sqlite3.h>

namespace cylon::store {
namespace {

namespace fs = std::filesystem;

constexpr const char* record = "track record projectile --engine in-house --repetitions 0 --store h.db";

class TrackStore : public cli::CommandLine {
 protected:
  void SetUp() override {
    ASSERT_EQ(cylon(record).code, 0);
    before_ = exported();
  }
  std::string exported() const { return cylon("track export - --store h.db").out; }

  // With `limits` before the command; root may write everything, so it is run without that right.
  void expect_refused(const std::string& limits, const std::string& command, const std::string& part) const {
    const std::string as_a_user =
        ::geteuid() == 0 ? "setpriv --inh-caps=-all --bounding-set=-all --no-new-privs " : "";
    const cli::Ran ran = shell(fmt::format("{} {}cylon {}", limits, as_a_user, command));
    EXPECT_EQ(ran.code, 2) << command << ": " << ran.out << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_TRUE(ran.err.starts_with("error: ")) << ran.err;
    EXPECT_NE(ran.err.find("h.db"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find(part), std::string::npos) << ran.err;
  }
  void expect_the_same() const { EXPECT_TRUE(exported() == before_); }

 private:
  std::string before_;
};
using TrackRecord = TrackStore;

TEST_F(TrackStore, ReportsReadOnlyFile) {
  fs::permissions(folder / "h.db", fs::perms::owner_read);
  expect_refused("", record, "read-only");
  expect_refused("", "track pin v1 --store h.db", "read-only");
  expect_the_same();
}

TEST_F(TrackStore, ReadsFromReadOnlyFolder) {
  for (const char* beside : {"h.db-wal", "h.db-shm"}) fs::remove(folder / beside);
  fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  expect_refused("", record, "folder cannot be written");
  const std::string as_a_user =
      ::geteuid() == 0 ? "setpriv --inh-caps=-all --bounding-set=-all --no-new-privs " : "";
  fs::permissions(folder, fs::perms::owner_all);
  const cli::Ran ran =
      shell("chmod 500 .; " + as_a_user + "cylon track list --store h.db; code=$?; chmod 700 .; exit $code");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("machine"), std::string::npos);
  expect_the_same();
}

// A limit of the file size stands for a full disk: both end a write in the middle.
TEST_F(TrackStore, ReportsFullDisk) {
  const auto blocks =
      fs::file_size(folder / "h.db") / 1024;  // of the log, which holds each changed page whole
  const cli::Ran ran =
      shell(fmt::format("ulimit -f {}; exec cylon track record 'two_sphere*' --engine 'in-house' "
                        "--repetitions 0 --store h.db",
                        blocks));
  EXPECT_EQ(ran.code, 2) << ran.out << ran.err;
  EXPECT_NE(ran.err.find("no room to write"), std::string::npos) << ran.err;
  const Store store = Store::open(folder / "h.db", Mode::write);
  EXPECT_TRUE(store.check().empty());
  EXPECT_TRUE(store.runs().at(0).complete);
  EXPECT_EQ(cylon("track record --resume --store h.db").code, 0);  // with room it goes on
  EXPECT_TRUE(store.runs().at(1).complete);
  EXPECT_GT(store.results(2).size(), 4u);
}

TEST_F(TrackStore, ReportsBusyStore) {
  sqlite3* other = nullptr;
  ASSERT_EQ(sqlite3_open((folder / "h.db").c_str(), &other), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr), SQLITE_OK);
  expect_refused("", record, "another process is writing");
  sqlite3_exec(other, "ROLLBACK", nullptr, nullptr, nullptr);
  sqlite3_close(other);
  expect_the_same();
}

TEST_F(TrackStore, MalformedImportAddsNothing) {
  write("good.csv", "revision,scenario,engine,metric,kind,value\n1,a,b,c,time,2\n");
  write("bad.csv", "revision,scenario,engine,metric,kind,value\n1,a,b,c,time,2\n1,a,b,d,time,fast\n");
  const cli::Ran ran = cylon("track import good.csv bad.csv --store h.db");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("bad.csv:3:1: column value: 'fast'"), std::string::npos) << ran.err;
  expect_the_same();
}

// Two at one time: each waits for the other's cells, and neither loses one.
TEST_F(TrackRecord, RejectsConcurrentRecording) {
  const std::string both = "track record 'two_sphere_head_on*' --engine ode --repetitions 0 --store h.db";
  const cli::Ran ran =
      shell(fmt::format("{{ cylon {0} & p=$!; cylon {0}; a=$?; wait $p; b=$?; exit $((a + b)); }}", both));
  EXPECT_EQ(ran.code, 0) << ran.err;
  const Store store = Store::open(folder / "h.db", Mode::read);
  EXPECT_TRUE(store.check().empty());
  ASSERT_EQ(store.runs().size(), 3u);
  EXPECT_EQ(store.results(2).size(), store.results(3).size());
  EXPECT_GT(store.results(2).size(), 4u);
}

}  // namespace
}  // namespace cylon::store
