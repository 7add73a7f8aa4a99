// Importing data ran programs: an imported anchor with an absolute path was executed by the next `track
// record`, and an imported unfinished run named commands that `track record --resume` ran.  What is imported
// is data.
#include "tests/harness/cli/fixture.h"

namespace cylon::cli {
namespace {

class ImportsRunNothing : public CommandLine {
 protected:
  bool ran() const { return std::filesystem::exists(folder / "ran"); }
};

TEST_F(ImportsRunNothing, AnImportedAnchorIsNotRun) {
  write("anchor.jsonl",
        "{\"cylon_history\": 1}\n{\"anchor\": {\"name\": \"v1\", \"binary\": \"in-house=/usr/bin/touch "
        "ran\", \"build\": "
        "\"d1127db5c616f73a\", \"date\": \"2030-01-01T00:00:00Z\", \"note\": \"\", \"run\": \"\"}}\n");
  ASSERT_EQ(cylon("track import anchor.jsonl --store h.db").code, 0);
  const Ran record = cylon("track record projectile --engine in-house --repetitions 1 --store h.db");
  EXPECT_EQ(record.code, 0) << record.err;
  EXPECT_NE(record.err.find("anchor 'v1' was not pinned by you here"), std::string::npos) << record.err;
  EXPECT_FALSE(ran());
  // One's own is run, and timed against.
  ASSERT_EQ(cylon("track pin v1 --store h.db").code, 0);
  ASSERT_EQ(cylon("track record projectile --engine in-house --repetitions 1 --store h.db").code, 0);
  ASSERT_EQ(cylon("track export --store h.db all.jsonl").code, 0);
  EXPECT_NE(read("all.jsonl").find("cpu_ratio:v1"), std::string::npos);
  // A store that somebody else pinned it in is somebody else's.
  const Ran foreign = shell(
      "export CYLON_KEY=\"$PWD/.other\"; exec cylon track record projectile --engine in-house --repetitions "
      "1 "
      "--store h.db");
  EXPECT_NE(foreign.err.find("anchor 'v1' was not pinned by you here"), std::string::npos) << foreign.err;
}

TEST_F(ImportsRunNothing, AnImportedRunIsNotResumed) {
  write("engine.sh", "touch ran\n[ -e hang ] && exec sleep 100\nexec " + std::string(binary_dir) +
                         "/cylon-worker-in-house\n");
  write("hang", "");
  const Ran cut = shell(
      "exec cylon track record projectile --worker 'mine=sh engine.sh' --engine mine --repetitions 0 --store "
      "h.db",
      [&] { return ran(); });
  EXPECT_EQ(cut.code, 130) << cut.err;
  ASSERT_EQ(
      shell("rm -f ran hang; cylon track export --store h.db all.jsonl; cylon track import all.jsonl --store "
            "other.db")
          .code,
      0);
  const Ran other = cylon("track record --resume --store other.db");
  EXPECT_EQ(other.code, 2) << other.out;
  EXPECT_NE(other.err.find("was imported, or begun by somebody else"), std::string::npos) << other.err;
  EXPECT_FALSE(ran());
  const Ran own = cylon("track record --resume --store h.db");
  EXPECT_EQ(own.code, 0) << own.err;
  EXPECT_TRUE(ran());
}

TEST_F(ImportsRunNothing, TwoProgramsDoNotResumeOneRun) {
  write("engine.sh", "touch ran; while [ -e hang ]; do sleep 0.02; done\nexec " + std::string(binary_dir) +
                         "/cylon-worker-in-house\n");
  write("hang", "");
  const Ran second = shell(
      "cylon track record projectile --worker 'mine=sh engine.sh' --engine mine --repetitions 0 --store h.db "
      "& "
      "while [ ! -e ran ]; do sleep 0.02; done; cylon track record --resume --store h.db; code=$?; rm hang; "
      "wait; "
      "exit $code");
  EXPECT_EQ(second.code, 2) << second.err;
  EXPECT_NE(second.err.find("another cylon is recording run 1"), std::string::npos) << second.err;
  EXPECT_NE(second.out.find("run 1 of"), std::string::npos) << second.out;
}

}  // namespace
}  // namespace cylon::cli
