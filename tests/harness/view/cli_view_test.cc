// The command cylon view: prints its address, ends on Ctrl-C with 0 and leaves no process behind.
#include "tests/harness/cli/fixture.h"

#include <filesystem>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;

class View : public CommandLine {
 protected:
  /// Processes that were started in the folder and live on.
  int left_over() const {
    int count = 0;
    std::error_code ignored;
    for (const fs::directory_entry& process : fs::directory_iterator("/proc", ignored))
      count += fs::read_symlink(process.path() / "cwd", ignored) == folder ? 1 : 0;
    return count;
  }
};

TEST_F(View, InterruptStopsWorkers) {
  int workers = 0;
  const auto shown = [&] {
    if (read(".out").find("#token=") == std::string::npos) return false;
    workers = left_over();  // the program itself is one
    return true;
  };
  const Ran ran =
      shell("exec cylon view dominoes --engine in-house --engine bullet --engine ode --no-open", shown);
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  EXPECT_GE(workers, 4);  // and an engine that is asked what it is
  EXPECT_EQ(left_over(), 0);
}

TEST_F(View, RecordingPassesItsClaim) {
  const Ran ran = cylon("view bouncing_sphere --engine ode --dt 1/240 --no-open --for 1 --record run.toml");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("recorded run.toml"), std::string::npos) << ran.out;
  EXPECT_EQ(cylon("validate run.toml").code, 0);
  const Ran same = cylon("run run.toml --engine ode");
  EXPECT_EQ(same.code, 0) << same.out;
  EXPECT_EQ(left_over(), 0);
}

TEST_F(View, PausedRecordsNothing) {
  const Ran ran = cylon("view bouncing_sphere --paused --no-open --for 0.2 --record run.toml");
  EXPECT_EQ(ran.code, 0);
  EXPECT_FALSE(fs::exists(folder / "run.toml"));
}

TEST_F(View, NamesUnsupportedEngine) {
  const Ran ran =
      cylon("view two_body_spring --engine ode --worker mine=false --engine mine --no-open --for 0.1");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("engine 'mine' is not installed"), std::string::npos) << ran.err;
  const Ran refused = cylon("view spherical_pendulum --engine bullet --no-open --for 0.1");
  EXPECT_EQ(refused.code, 0);
  EXPECT_NE(refused.err.find("bullet: unsupported: "), std::string::npos) << refused.err;
}

TEST_F(View, RejectsInvalidRequests) {
  for (const char* arguments :
       {"view", "view no_such_scene", "view gas --engine bulet", "view gas --engine ode --integrator rk4",
        "view gas --dt 0", "view gas --speed 0", "view gas --speed 1000", "view gas --port 70000",
        "view gas --for -1", "view gas --engine ode --engine ode --engine ode --engine ode --engine ode",
        "view gas --record /dev/null/frames"}) {
    const Ran ran = cylon(std::string(arguments) + " --no-open");
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_NE(ran.err.find("error: "), std::string::npos) << arguments;
    EXPECT_EQ(ran.out, "") << arguments;
  }
}

}  // namespace
}  // namespace cylon::cli
