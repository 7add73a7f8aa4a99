// A stdout or a journal that could not be written was exit code 0 and silence, a file size limit killed
// `run`, two runs in one folder cut each other's journal, and a signal while files are read did nothing for
// minutes.
#include "tests/harness/cli/fixture.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace cylon::cli {
namespace {

using OutputsThatFail = CommandLine;

TEST_F(OutputsThatFail, AFullDiskIsAnError) {
  for (const char* command :
       {"list --names", "engines --names", "--help", "run projectile --engine in-house --json -",
        "simulate projectile --engine in-house --out -"}) {
    const Ran ran = shell("exec cylon " + std::string(command) + " > /dev/full");
    EXPECT_EQ(ran.code, 5) << command;
    EXPECT_NE(ran.err.find("stdout cannot be written"), std::string::npos) << command << ran.err;
  }
}

// `cylon engines | head` ended with an error of the harness.
TEST_F(OutputsThatFail, AReaderThatLeavesIsNoError) {
  const Ran ran = shell("bash -c 'exec > >(exit 0); wait $!; exec cylon list --names'");
  EXPECT_EQ(ran.code, 141);
  EXPECT_EQ(ran.err, "");
}

// Names that cannot be looked up were internal errors.
TEST_F(OutputsThatFail, ANameThatIsNoneIsRefused) {
  shell("ln -s loop loop");
  for (const std::string& name : {std::string(5000, 'n'), std::string("loop/file")})
    for (const char* command : {"run projectile --engine in-house --json ",
                                "run projectile --engine in-house --plots ", "trade projectile --json "}) {
      const Ran ran = cylon(command + name);
      EXPECT_EQ(ran.code, 2) << command << ran.err;
      EXPECT_TRUE(ran.err.starts_with("error: ")) << command << ran.err;
    }
}

TEST_F(OutputsThatFail, AJournalThatCannotBeWrittenIsTold) {
  // 1 block of 512 bytes: the first line fits, the cell's does not.
  const Ran ran = shell("ulimit -f 1; exec cylon run projectile --engine in-house >/dev/null");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find(".cylon/journal.jsonl cannot be written (File too large)"), std::string::npos)
      << ran.err;
  write("file", "");
  const Ran blocked =
      shell("rm -r .cylon; ln -s ../file .cylon; exec cylon run projectile --engine in-house");
  EXPECT_EQ(blocked.code, 0) << blocked.err;
  EXPECT_NE(blocked.err.find("what follows cannot be resumed"), std::string::npos) << blocked.err;
}

// A child that a killed run was about to start has the journal's lock for an instant more.
TEST_F(OutputsThatFail, AJournalIsFreeAnInstantAfterTheRun) {
  const Ran ran = shell(
      "mkdir -p .cylon; (exec 9> .cylon/journal.jsonl; flock 9; touch held; sleep 0.3) & "
      "while [ ! -e held ]; do sleep 0.02; done; cylon run projectile --engine in-house; code=$?; wait; exit "
      "$code");
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
}

TEST_F(OutputsThatFail, TwoRunsInOneFolderDoNotShareAJournal) {
  // Its first start is asked for its version, before the journal is open.
  write("engine.sh",
        "[ ! -e asked ] || { touch started; while [ -e hang ]; do sleep 0.02; done; }\ntouch asked\nexec " +
            std::string(binary_dir) + "/cylon-worker-in-house\n");
  write("hang", "");
  const Ran ran = shell(
      "cylon run projectile --worker 'slow=sh engine.sh' --engine slow > first.txt 2>&1 & "
      "while [ ! -e started ]; do sleep 0.02; done; cylon run projectile --engine in-house; code=$?; rm "
      "hang; wait; "
      "exit $code");
  EXPECT_EQ(ran.code, 2) << ran.out << ran.err;
  EXPECT_NE(ran.err.find("another cylon is at work in this folder"), std::string::npos) << ran.err;
  EXPECT_NE(read("first.txt").find(" verdicts: "), std::string::npos);
}

// Somebody else's journal names programs; none of them is run.
TEST_F(OutputsThatFail, AJournalOfAnotherUserIsNotRead) {
  write("engine.sh", "touch ran\nexec " + std::string(binary_dir) + "/cylon-worker-in-house\n");
  ASSERT_EQ(cylon("run projectile --worker 'mine=sh engine.sh' --engine mine").code, 0);
  EXPECT_NE(cylon("run --resume").err.find("resumed: 1 of 1 cells"), std::string::npos);
  const std::string journal = read(".cylon/journal.jsonl");
  for (const std::string& change :
       {std::string("rm .key ran"), std::string("rm ran; mkdir b; cp -r .cylon b; cd b")}) {
    write(".cylon/journal.jsonl", journal);
    const Ran ran = shell(change + "; exec cylon run --resume");
    EXPECT_EQ(ran.code, 2) << change << ran.out << ran.err;
    EXPECT_NE(ran.err.find("were not written by you in this folder"), std::string::npos) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "ran")) << change;
    shell("touch ran");
  }
}

TEST_F(OutputsThatFail, AnInterruptedRunReportsWhatIsDone) {
  write("engine.sh", "[ -e asked ] && [ -e hang ] && exec sleep 100\ntouch asked\nexec " +
                         std::string(binary_dir) + "/cylon-worker-in-house\n");
  write("hang", "");
  const Ran ran = shell(
      "exec cylon run projectile -j 1 --worker 'slow=sh engine.sh' --engine in-house --engine slow --json "
      "out.json",
      [&] {
        const std::string journal = read(".cylon/journal.jsonl");
        return std::count(journal.begin(), journal.end(), '\n') >= 3;
      });
  EXPECT_EQ(ran.code, 130) << ran.err;
  const auto verdicts = nlohmann::json::parse(read("out.json")).at("verdicts");
  EXPECT_FALSE(verdicts.empty());
  for (const auto& row : verdicts) EXPECT_EQ(row.at("engine"), "in-house");
}

TEST_F(OutputsThatFail, ASignalEndsTheReading) {
  // Certified truths of stars for hundreds of seconds.
  write("slow.toml", [] {
    std::string text = "duration = 1000\nstep = 0.001\n";
    for (int i = 0; i < 20; ++i) {
      text += "[[body]]\nname = \"b" + std::to_string(i) + "\"\nmass = 1\nposition = [" +
              std::to_string(i * 1.1) + ", " + std::to_string(i * i * 0.3) + ", " + std::to_string(i % 3) +
              "]\n";
      for (int j = 0; j < i; ++j)
        text += "[[attraction]]\nbody = \"b" + std::to_string(i) + "\"\nto = \"b" + std::to_string(j) +
                "\"\nstrength = 1\n";
    }
    return text +
           "[[claim]]\nfollows = \"certified\"\nobservable = \"position\"\nuntil = \"horizon\"\n"
           "tolerance = { absolute = 1e-3, reason = \"r\" }\n";
  }());
  for (const char* signal : {"INT", "TERM"}) {
    // bash's background jobs ignore SIGINT, so timeout sends it.
    const Ran ran =
        shell(std::string("timeout -s ") + signal + " 1 env CYLON_CACHE=off cylon validate slow.toml");
    EXPECT_EQ(ran.code, 124) << signal << ran.out << ran.err;  // timeout's word for "it had to be ended"
  }
}

}  // namespace
}  // namespace cylon::cli
