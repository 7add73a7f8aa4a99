// What a command reads it does not write over, and what it is asked for but cannot do it says before it begins.
#include "tests/harness/cli/fixture.h"

#include <vector>

namespace cylon::cli {
namespace {

class Inputs : public CommandLine {
 protected:
  void SetUp() override {
    text_ = read(std::filesystem::path(source_dir) / "docs/examples/swing.toml");
    write("a.toml", text_);
    write("engine.py", read(std::filesystem::path(source_dir) / "docs/examples/foreign_engine.py"));
  }
  std::string text_;
};

// Each of these replaced the scenario, the engine or the history, and ended with 0.
TEST_F(Inputs, AreNeverReplaced) {
  for (const char* command :
       {"run a.toml --engine in-house --json a.toml", "run a.toml --engine in-house --csv ./a.toml",
        "run a.toml --engine in-house --html=a.toml", "simulate a.toml --out a.toml",
        "truth a.toml --at 0,0.5 --out a.toml", "trade a.toml --engine in-house --json $PWD/a.toml",
        "diff a.toml in-house ode --csv a.toml", "advise a.toml --json a.toml",
        "limits a.toml --engine in-house --json a.toml", "matrix a.toml --engine ode --json a.toml"}) {
    const Ran ran = cylon(command);
    EXPECT_EQ(ran.code, 2) << command << ran.out;
    EXPECT_NE(ran.err.find("a.toml: is named twice on the command line"), std::string::npos) << ran.err;
    EXPECT_EQ(read("a.toml"), text_) << command;
  }
  const std::string engine = read("engine.py");
  const Ran ran = cylon("run a.toml --worker 'mine=python3 engine.py' --engine mine --json engine.py");
  EXPECT_EQ(ran.code, 2) << ran.out;
  EXPECT_EQ(read("engine.py"), engine);
}

TEST_F(Inputs, AndTwoOutputsAreTwoFiles) {
  const Ran ran = cylon("simulate a.toml --out x.csv --account x.csv");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("x.csv: two reports cannot be written to the same file"), std::string::npos)
      << ran.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "x.csv"));
}

TEST_F(Inputs, AHistoryIsNotExportedOverItself) {
  ASSERT_EQ(cylon("track record a.toml --engine in-house --repetitions 0").code, 0);
  const Ran ran = cylon("track export .cylon/history.db");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find(".cylon/history.db: is the history itself"), std::string::npos) << ran.err;
  EXPECT_EQ(cylon("track list").code, 0);
}

TEST_F(Inputs, AreRefusedWithTheOptionAndTheValue) {
  const std::string mine = "--worker 'mine=python3 engine.py' ";
  const struct {
    std::string command, says;
  } rows[] = {
      {"run a.toml --tolerance-scale nan", "'nan' must be a number from 0 to"},
      {"diff a.toml ode ode --tolerance nan", "'nan' must be a number from 0 to"},
      {"run a.toml " + mine + mine, "'mine' is given twice"},
      {"view a.toml --record none/x.toml --no-open --for 1", "the folder"},
      {"hunt --replay . --json f.json", "--json excludes --replay"},
      {"hunt --replay . --count 3", "--count excludes --replay"},
  };
  for (const auto& [command, says] : rows) {
    const Ran ran = cylon(command);
    EXPECT_EQ(ran.code, 2) << command << ran.out;
    EXPECT_NE(ran.err.find(says), std::string::npos) << command << ": " << ran.err;
  }
}

TEST_F(Inputs, AWorkerThatStandsInForAnEngineOfOursIsSaid) {
  const Ran ran = cylon("run a.toml --worker 'ode=python3 engine.py' --engine ode --dt 1/500");
  EXPECT_NE(ran.err.find("stands in for the engine 'ode'"), std::string::npos) << ran.err;
}

// A scenario without claims was green, and beside others it was gone without a word.
TEST_F(Inputs, WithoutClaimsAreNoSuccess) {
  write("none.toml", text_.substr(0, text_.find("[[claim]]")));
  const Ran alone = cylon("run none.toml --engine in-house");
  EXPECT_EQ(alone.code, 4) << alone.out;
  EXPECT_NE(alone.err.find("none claims nothing"), std::string::npos) << alone.err;
  const Ran beside = cylon("run none.toml a.toml --engine in-house");
  EXPECT_NE(beside.err.find("none claims nothing"), std::string::npos) << beside.err;
  EXPECT_NE(beside.code, 4);
}

// Claims that compared nothing but the start passed on every engine, whatever it did.
TEST_F(Inputs, ClaimsThatCompareNothingAreRefused) {
  const auto with = [&](const std::string& claim) {
    write("c.toml", text_.substr(0, text_.find("[[claim]]")) + "[[claim]]\n" + claim +
                        "\ntolerance = { absolute = 1e-3, reason = \"a test\" }\n");
    return cylon("run c.toml --engine in-house");
  };
  ASSERT_EQ(cylon("truth a.toml --at 0,0.25,0.5,0.75,1 --out t.json").code, 0);
  const std::string follows = "follows = { file = \"t.json\" }\nobservable = \"position\"\n";
  Ran ran = with(follows);
  EXPECT_EQ(ran.code, 2) << ran.out;
  EXPECT_NE(ran.err.find("t.json ends at 1 s, and the claim at"), std::string::npos) << ran.err;
  ran = with(follows + "until = 1\n");
  EXPECT_EQ(ran.code, 0) << ran.err << ran.out;
  with("conserves = \"energy\"\nuntil = 0.002\n");
  ran = cylon("run c.toml --engine in-house --dt 1/100 -v");
  EXPECT_EQ(ran.code, 1) << ran.out;
  EXPECT_NE(ran.out.find("within the first step"), std::string::npos) << ran.out;
  ran = with("conserves = \"energy\"\nuntil = 1e-9\n");
  EXPECT_EQ(ran.code, 2) << ran.out;
  EXPECT_NE(ran.err.find("until = 1e-09, but must be at least a step"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace cylon::cli
