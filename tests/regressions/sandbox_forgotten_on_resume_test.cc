// No journal, recording or anchor knew that its engines had run in the sandbox: what was begun by `cylon --sandbox run` and
// resumed by `cylon run --resume` started a stranger's engine without it, in silence, and the printed command to
// repeat a row did the same.
#include "harness/tracking/store/store.h"
#include "tests/harness/cli/fixture.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <exception>
#include <filesystem>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class SandboxForgottenOnResume : public CommandLine {
 protected:
  void SetUp() override {
    if (std::system("command -v bwrap >/dev/null") != 0) GTEST_SKIP() << "bubblewrap is not installed";
    write("engine.sh",
          "#!/bin/sh\ntouch unconfined 2>/dev/null\nmode=good\n[ -e hang ] && mode=loop_in_run\nexec python3 "
          "\"$1\" $mode\n");
    fs::permissions(folder / "engine.sh", fs::perms::owner_all);
  }

  // A stranger's engine, which leaves a file wherever it can write one, and does not end while there is a file `hang`.
  static std::string stranger() {
    return " --engine mine --worker 'mine=./engine.sh " + std::string(source_dir) +
           "/tests/harness/process/scripted_worker.py'";
  }
  bool ran_unconfined() const { return fs::exists(folder / "unconfined"); }
  void expect_refused(const std::string& arguments) const {
    const Ran ran = cylon(arguments);
    EXPECT_EQ(ran.code, 2) << arguments << ran.out << ran.err;
    EXPECT_NE(ran.err.find("repeat the command as `cylon --sandbox …`"), std::string::npos)
        << arguments << ran.err;
    EXPECT_FALSE(ran_unconfined()) << arguments;
  }
};

TEST_F(SandboxForgottenOnResume, OfARun) {
  write("hang", "");
  const Ran cut = shell("exec cylon --sandbox run projectile -j 1 --engine in-house" + stranger(), [&] {
    return read(".cylon/journal.jsonl").find("\"verdicts\"") != std::string::npos;
  });
  EXPECT_EQ(cut.code, 130) << cut.err;
  EXPECT_NE(cut.err.find("continue with `cylon --sandbox run --resume`"), std::string::npos) << cut.err;
  fs::remove(folder / "hang");
  expect_refused("run --resume");
  expect_refused("run --rerun-failed");
  const Ran same = cylon("--sandbox run --resume --json out.json");
  EXPECT_TRUE(same.code == 0 || same.code == 1) << same.err;
  EXPECT_FALSE(ran_unconfined());
  for (const json& row : json::parse(read("out.json")).at("verdicts"))
    EXPECT_TRUE(row.at("reproduce").get<std::string>().starts_with("cylon --sandbox run projectile")) << row;
  // Begun anew without it, it is the user's word; the test would see such an engine.
  const Ran open = cylon("run projectile --json out.json" + stranger());
  EXPECT_TRUE(open.code == 0 || open.code == 1) << open.err;
  EXPECT_TRUE(ran_unconfined());
  EXPECT_EQ(read("out.json").find("--sandbox"), std::string::npos);
  EXPECT_EQ(cylon("run --resume").code, open.code);
}

TEST_F(SandboxForgottenOnResume, OfARecording) {
  write("hang", "");
  const auto begun = [&] {
    try {
      return !store::Store::open(folder / "h.db", store::Mode::read).runs().empty();
    } catch (const std::exception&) {  // it is not there yet
      return false;
    }
  };
  const Ran cut =
      shell("exec cylon --sandbox track record projectile --repetitions 0 --store h.db" + stranger(), begun);
  EXPECT_EQ(cut.code, 130) << cut.err;
  fs::remove(folder / "hang");
  expect_refused("track record --resume --store h.db");
  const Ran same = cylon("--sandbox track record --resume --store h.db");
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_FALSE(ran_unconfined());
}

TEST_F(SandboxForgottenOnResume, OfAnAnchor) {
  ASSERT_EQ(cylon("--sandbox track pin v1 --store h.db" + stranger()).code, 0);
  expect_refused("track record projectile --engine in-house --repetitions 1 --store h.db");
  const Ran same = cylon("--sandbox track record projectile --engine in-house --repetitions 1 --store h.db");
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_FALSE(ran_unconfined());
  ASSERT_EQ(cylon("track export --store h.db all.jsonl").code, 0);
  EXPECT_NE(read("all.jsonl").find("cpu_ratio:v1"), std::string::npos);
}

// Every journal is a LineFile, which says it for all commands.
TEST_F(SandboxForgottenOnResume, OfEveryOtherJournal) {
  for (const std::string command :
       {"trade projectile --engine in-house --integrator rk4 --steps 3 --rounds 0",
        "matrix projectile --engine in-house --finest 0.01 --rounds 0", "limits spring --engine in-house",
        "hunt --engine in-house --count 2",
        "advise projectile --verify --engine in-house --integrator rk4"}) {
    const Ran first = cylon("--sandbox " + command);
    EXPECT_TRUE(first.code == 0 || first.code == 1) << command << first.err;
    expect_refused(command + " --resume");
    const Ran same = cylon("--sandbox " + command + " --resume");
    EXPECT_EQ(same.code, first.code) << command << same.err;
  }
}

TEST_F(SandboxForgottenOnResume, OfAUnionOfShards) {
  ASSERT_EQ(cylon("--sandbox run projectile --engine in-house --shard 1/1").code, 0);
  ASSERT_EQ(cylon("merge .cylon/journal-1-of-1.jsonl").code, 0);  // which runs nothing
  expect_refused("run projectile --engine in-house --resume");
  EXPECT_EQ(cylon("--sandbox run projectile --engine in-house --resume").code, 0);
}

TEST_F(SandboxForgottenOnResume, OfTheCommandToCompareACellAgain) {
  const Ran ran =
      cylon("--sandbox track compare projectile --engine in-house --no-time --instructions off --baseline '" +
            std::string(binary_dir) + "' --json out.json");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(read("out.json").find("\"cylon --sandbox track compare "), std::string::npos) << read("out.json");
}

}  // namespace
}  // namespace cylon::cli
