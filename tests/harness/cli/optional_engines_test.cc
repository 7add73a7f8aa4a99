// An optional engine that is not here: said by each command, with what brings it, and never a failure.  The folder of
// workers is one of links to all others, so it is the same where the engine is installed.
#include "tests/harness/cli/fixture.h"
#include "tests/paths.h"

#include "harness/process/engine_table.h"
#include "harness/process/engines.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace cylon::cli {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

class OptionalEngines : public CommandLine {
 protected:
  void SetUp() override {
    fs::create_directory(folder / "workers");
    for (const process::BuiltEngine& one : process::engine_table()) {
      const std::string worker = std::string("cylon-worker-") + one.build;
      const bool linked = fs::is_symlink(folder / "workers" / worker);
      if (!*one.brought_by && !linked)
        fs::create_symlink(fs::path(binary_dir) / worker, folder / "workers" / worker);
    }
  }

  Ran cylon(const std::string& arguments) const {
    return shell("export CYLON_WORKERS=\"$PWD/workers\"; exec cylon " + arguments);
  }
};

constexpr const char* sentence = "mujoco is not here; `./run engines` brings it";

TEST_F(OptionalEngines, AreListedWithWhatBringsThem) {
  const Ran here = cylon("engines --here");
  EXPECT_EQ(here.code, 0) << here.err;
  EXPECT_NE(here.out.find("mujoco: not here: `./run engines` brings it\n"), std::string::npos) << here.out;
  EXPECT_NE(here.out.find("ode: here: ode 0.16"), std::string::npos) << here.out;

  const Ran all = cylon("engines --json");
  EXPECT_EQ(all.code, 0) << all.err;
  const json rows = json::parse(all.out);
  std::size_t listed = 0;
  for (const process::BuiltEngine& one : process::engine_table()) {
    const json& row = rows.at(listed++);
    EXPECT_EQ(row.at("id"), one.id);
    EXPECT_EQ(row.at("here"), !*one.brought_by) << row;
    EXPECT_EQ(row.contains("brought_by"), *one.brought_by != 0) << row;
  }
  EXPECT_EQ(cylon("engines mujoco").code, 0);
}

TEST_F(OptionalEngines, AreUnsupportedWhereTheyAreNamed) {
  const Ran ran = cylon("run projectile --engine in-house --engine mujoco --json rows.json");
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("4 as expected (4 unsupported), 0 differ"), std::string::npos) << ran.out;
  int rows = 0;
  const json written = json::parse(read("rows.json"));
  for (const json& row : written.at("verdicts")) {
    if (row.at("engine") != "mujoco") continue;
    ++rows;
    EXPECT_EQ(row.at("status"), "unsupported");
    EXPECT_EQ(row.at("detail"), sentence);
  }
  EXPECT_EQ(rows, 4);
}

TEST_F(OptionalEngines, AreNoFailureOfTheMachine) {
  const Ran ran = cylon("doctor");
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find(sentence), std::string::npos) << ran.out;
  EXPECT_EQ(ran.out.find("FAIL"), std::string::npos) << ran.out;
}

// Other engines stand for two that are here: one of which there are rows, and one that nobody knows.
TEST_F(OptionalEngines, AreToldWhereNoVerdictIsExpectedOfThem) {
  fs::create_symlink(fs::path(binary_dir) / "cylon-worker-ode", folder / "workers/cylon-worker-mujoco");
  fs::create_symlink(fs::path(source_dir) / "docs/examples/foreign_engine.py",
                     folder / "workers/cylon-worker-siconos");
  const Ran ran = cylon("doctor");
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
  for (const auto& [engine, told] : {std::pair{"mujoco", false}, std::pair{"siconos", true}}) {
    const std::size_t at = ran.out.find(fmt::format("ok    engine {}: ", engine));
    ASSERT_NE(at, std::string::npos) << ran.out;
    const std::string line = ran.out.substr(at, ran.out.find('\n', at) - at);
    EXPECT_EQ(line.find("expected.toml has no row of it: a pass is expected") != std::string::npos, told)
        << line;
  }
}

// One engine asked for one thing cannot do it: that is told as for any worker that cannot be had.
TEST_F(OptionalEngines, CannotBeSimulated) {
  const Ran ran = cylon("simulate projectile --engine mujoco");
  EXPECT_EQ(ran.code, 5);
  EXPECT_NE(ran.err.find(sentence), std::string::npos) << ran.err;
}

// cylon limits ended with an internal error, and cylon hunt with 0 faults in scenes that nobody ran.
TEST_F(OptionalEngines, AreToldByCommandsThatCompareThem) {
  struct Row {
    const char* command;
    int code;
  };
  for (const auto& [command, code] : {
           Row{"limits spring --engine mujoco", 0},
           Row{"limits projectile --engine ode --engine mujoco --integrator 'semi*'", 0},
           Row{"hunt --engine mujoco --count 2 --cards cards", 4},
           Row{"trade projectile --engine mujoco --rounds 0 --steps 2", 4},
           Row{"advise projectile --engine mujoco --rounds 1", 4},
           Row{"matrix projectile --engine mujoco --rounds 0", 4},
           Row{"engines --fingerprint mujoco", 0},
       }) {
    const Ran ran = cylon(command);
    EXPECT_EQ(ran.code, code) << command << ran.out << ran.err;
    EXPECT_NE((ran.out + ran.err).find(sentence), std::string::npos) << command << ran.out << ran.err;
    EXPECT_EQ(ran.out.find("mujoco: 0 of"), std::string::npos) << command << ran.out;
  }
}

// Commands that take all engines where none is named take the others.
TEST_F(OptionalEngines, TakePartOnlyWhereTheyAreNamed) {
  for (const char* command : {"matrix projectile --rounds 1 --finest 0.01", "advise projectile --rounds 1"}) {
    const Ran ran = cylon(command);
    EXPECT_EQ(ran.code, 0) << command << ran.err;
    EXPECT_EQ(ran.out.find("mujoco"), std::string::npos) << command << ran.out;
    EXPECT_NE(ran.out.find("ode"), std::string::npos) << command << ran.out;
  }
}

TEST(OptionalEnginesTable, HasRowsThatSayWhatBringsThem) {
  int optional = 0;
  for (const process::EngineRow& row : process::default_engines("/no/such/folder")) {
    optional += row.optional();
    EXPECT_EQ(process::missing(row).has_value(), row.optional())
        << row.id << ": others are the build's failure";
  }
  EXPECT_GT(optional, 0);
  for (const process::EngineRow& row : process::usual(process::default_engines("/no/such/folder")))
    EXPECT_FALSE(row.optional()) << row.id;
}

// Its library was taken away after it was built; the loader ends it with 127.  That is a broken installation, as of any
// worker that cannot start, and the other engine has its verdicts.
TEST_F(OptionalEngines, SayWhatBringsALibraryThatIsGone) {
  std::ofstream(folder / "workers/cylon-worker-mujoco")
      << "#!/bin/sh\necho 'libmujoco.so.2.2.2: cannot open shared object file' >&2\nexit 127\n";
  fs::permissions(folder / "workers/cylon-worker-mujoco", fs::perms::owner_all);
  const Ran ran = cylon("run projectile --engine in-house --engine mujoco --json rows.json");
  EXPECT_EQ(ran.code, 5) << ran.out << ran.err;
  const json written = json::parse(read("rows.json"));
  int rows = 0;
  for (const json& row : written.at("verdicts")) {
    if (row.at("engine") != "mujoco") continue;
    ++rows;
    EXPECT_EQ(row.at("status"), "unsupported");
    const auto detail = row.at("detail").get<std::string>();
    EXPECT_NE(detail.find("cannot open shared object file; `./run engines` brings what it needs"),
              std::string::npos)
        << detail;
  }
  EXPECT_EQ(rows, 4);
}

// Of one that is here.
TEST_F(OptionalEngines, EndWithTwoWhereAnOptionHasNoSuchValue) {
  const process::EngineChoice siconos =
      process::parse_engine("siconos", process::default_engines(binary_dir));
  if (const auto reason = process::missing(siconos.row)) GTEST_SKIP() << *reason;
  const Ran ran = shell("exec cylon run slide_to_roll --engine siconos/solver=soclcp");
  EXPECT_EQ(ran.code, 2) << ran.out << ran.err;
  EXPECT_NE(ran.err.find("no value of option solver 'soclcp' (valid: nsgs, "), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace cylon::cli
