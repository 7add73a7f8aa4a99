// A worker that answered {"error": …} to load, or any exception inside a cell, ended the whole run with exit
// code 2 and no report.  What happens in a cell is that cell's row now, and the others go on.
#include "tests/harness/cli/fixture.h"

#include <nlohmann/json.hpp>

namespace cylon::cli {
namespace {

using nlohmann::json;

class MatrixGoesOn : public CommandLine {
 protected:
  static std::string broken(const std::string& mode) {
    return " --worker 'broken=python3 " + std::string(source_dir) +
           "/tests/harness/process/scripted_worker.py " + mode + "'";
  }
  std::string status_of(const std::string& engine) const {
    std::string status;
    const json report = json::parse(read("out.json"));
    for (const json& row : report.at("verdicts"))
      if (row.at("engine") == engine) status = row.at("status");
    return status;
  }
};

TEST_F(MatrixGoesOn, AfterAnEngineThatRefusesTheLoad) {
  const Ran ran = cylon(
      "run projectile --engine broken --engine in-house --json out.json --junit out.xml --csv out.csv"
      " --html out.html" +
      broken("refuses_load"));
  EXPECT_EQ(ran.code, 2) << ran.err;
  EXPECT_NE(ran.err.find("projectile on broken: engine 'broken': this worker takes no scene"),
            std::string::npos)
      << ran.err;
  EXPECT_EQ(status_of("in-house"), "pass");
  EXPECT_EQ(status_of("broken"), "unsupported");
  for (const char* file : {"out.xml", "out.csv", "out.html"}) EXPECT_FALSE(read(file).empty()) << file;
}

TEST_F(MatrixGoesOn, AfterADeeplyNestedLine) {
  const Ran ran =
      cylon("run projectile --engine broken --engine in-house --json out.json" + broken("deep_line_in_load"));
  EXPECT_EQ(ran.code, 5) << ran.err;
  EXPECT_EQ(status_of("in-house"), "pass");
  EXPECT_EQ(status_of("broken"), "protocol");
}

// No descriptor is left for the pipes: a failure of the harness, which is told, and run again with --resume.
TEST_F(MatrixGoesOn, WithoutProcessesAndIsResumed) {
  const Ran ran = shell("ulimit -n 12; exec cylon run projectile --engine in-house --json out.json");
  EXPECT_EQ(ran.code, 5) << ran.out << ran.err;
  EXPECT_NE(ran.err.find("projectile on in-house: the harness failed: pipe"), std::string::npos) << ran.err;
  EXPECT_EQ(status_of("in-house"), "crash");
  const Ran again = cylon("run --resume --json out.json");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_NE(again.err.find("resumed: 0 of 1 cells"), std::string::npos) << again.err;
  EXPECT_EQ(status_of("in-house"), "pass");
}

// The other commands that ask many runs said "internal error: pipe" and lost what they had; single ones said the same.
TEST_F(MatrixGoesOn, WithoutProcessesInOtherCommands) {
  for (const char* command : {"trade projectile --engine in-house --integrator rk4 --steps 3 --rounds 0",
                              "limits spring --engine in-house", "hunt --engine in-house --count 2",
                              "simulate projectile", "advise projectile --engine in-house"}) {
    const Ran ran = shell(std::string("ulimit -n 10; exec cylon ") + command);
    EXPECT_EQ(ran.code, 5) << command << ran.err;
    EXPECT_NE(ran.err.find("the harness failed: pipe"), std::string::npos) << command << ran.err;
    EXPECT_EQ(ran.err.find("internal error"), std::string::npos) << command << ran.err;
  }
  // A few descriptors more, and the engine can say what it is, though not search: the search is told, and done again.
  for (int most = 11; most < 30; ++most) {
    const std::string limit = "ulimit -n " + std::to_string(most);
    const Ran ran = shell(limit + "; exec cylon limits spring --engine in-house --json l.json");
    if (ran.code == 0) break;
    EXPECT_EQ(ran.code, 5) << limit << ran.err;
    EXPECT_TRUE(ran.err.starts_with("error: ")) << limit << ran.err;
  }
  const Ran again = cylon("limits spring --engine in-house --resume --json l.json");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(json::parse(read("l.json")).at("limits").size(), 1u);
}

// Threads that the system refuses ended the program; fewer do the same work now.
TEST_F(MatrixGoesOn, WithoutThreads) {
  const Ran ran = shell(
      "ulimit -v 900000; ulimit -s 500000; exec cylon run 'projectile:spring_*' --engine in-house -j 8 "
      "--json out.json");
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
  EXPECT_EQ(status_of("in-house"), "pass");
}

}  // namespace
}  // namespace cylon::cli
