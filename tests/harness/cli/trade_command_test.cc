// `cylon trade` as its user runs it: interrupted and resumed, with engines that break.
#include "tests/harness/cli/fixture.h"
#include "tests/paths.h"

#include <nlohmann/json.hpp>

namespace cylon::cli {
namespace {

class Trade : public CommandLine {
 protected:
  nlohmann::json tables(const std::string& file) const { return nlohmann::json::parse(read(file))["tables"]; }
  static std::string broken(const std::string& mode) {
    return "--worker 'broken=python3 " + std::string(source_dir) +
           "/tests/harness/process/scripted_worker.py " + mode + "'";
  }
};

constexpr const char* small =
    "trade projectile --engine in-house --integrator rk4 --integrator lie-trotter --engine ode --steps "
    "5 "
    "--rounds 1";

TEST_F(Trade, ResumedSweepEqualsUninterrupted) {
  ASSERT_EQ(cylon(std::string(small) + " --json whole.json").code, 0);
  const std::string journal = read(".cylon/trade.jsonl");
  // What an interruption leaves: some lines, and half of one.
  write(".cylon/trade.jsonl", journal.substr(0, journal.size() / 3));
  const Ran ran = cylon(std::string(small) + " --json resumed.json --resume");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("runs are done already"), std::string::npos);
  EXPECT_EQ(ran.err.find("resumed: 0"), std::string::npos) << ran.err;
  EXPECT_EQ(tables("whole.json"), tables("resumed.json"));
}

TEST_F(Trade, AnInterruptionExits130AndKeepsWhatIsDone) {
  const Ran ran = shell("exec cylon trade projectile --rounds 50 --json never.json",
                        [&] { return read(".cylon/trade.jsonl").size() > 2000; });
  EXPECT_EQ(ran.code, 130) << ran.err;
  EXPECT_NE(ran.err.find("--resume"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "never.json"));
}

TEST_F(Trade, IgnoresJournalOfOtherContent) {
  write("mine.toml", shipped("projectile"));
  const std::string command = "trade mine.toml --engine ode --steps 4 --rounds 0 --json ";
  ASSERT_EQ(cylon(command + "a.json").code, 0);
  write("mine.toml", replaced(shipped("projectile"), "[3, 4, 0.5]", "[3, 5, 0.5]"));
  ASSERT_EQ(cylon(command + "b.json --resume").code, 0);
  EXPECT_NE(tables("a.json")[0]["series"][0]["points"], tables("b.json")[0]["series"][0]["points"]);
}

TEST_F(Trade, FailedEngineGetsARow) {
  for (const auto& [mode, status] : std::vector<std::pair<std::string, std::string>>{
           {"abort_in_run", "crash"}, {"nan", "non-finite"}, {"nonsense", "ran"}, {"shaves", "protocol"}}) {
    const Ran ran = cylon(
        "trade projectile --engine broken --engine ode --steps 2 --rounds 1 --json t.json " + broken(mode));
    EXPECT_EQ(ran.code, 0) << mode << ran.err;
    const auto series = tables("t.json")[0]["series"];
    ASSERT_EQ(series.size(), 2u) << mode;
    for (const auto& point : series[0]["points"]) {
      EXPECT_EQ(point["status"], status) << mode;
      if (status != "ran") continue;
      EXPECT_GT(point["errors"]["trajectory"], 1e20);
    }
    EXPECT_EQ(series[1]["points"][0]["status"], "ran");
  }
}

TEST_F(Trade, MeasuresConservationWithoutClaims) {
  write("bare.toml",
        "title = 'Two on a spring'\nduration = 2\nstep = 0.01\n"
        "[[body]]\nname = 'a'\nmass = 1\nposition = [0.3, 0.1, -0.2]\nvelocity = [0, 1, 0.5]\n"
        "[[body]]\nname = 'b'\nmass = 2\nposition = [1.4, -0.3, 0.6]\nvelocity = [0.2, 0, -0.4]\n"
        "[[spring]]\nbody = 'a'\nto = 'b'\nstiffness = 30\nrest_length = 0.8\n");
  const Ran ran = cylon(
      "trade bare.toml --engine in-house --integrator velocity-verlet --integrator semi-implicit-euler "
      "--engine bullet --rounds 0 --json "
      "t.json");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto table = tables("t.json")[0];
  EXPECT_NE(table["truth"].get<std::string>().find("not certified"), std::string::npos);
  std::vector<std::string> names;
  for (const auto& m : table["measures"]) names.push_back(m["name"]);
  EXPECT_EQ(names, (std::vector<std::string>{"trajectory", "position", "orientation", "energy",
                                             "linear_momentum", "angular_momentum"}));
  EXPECT_NEAR(table["series"][0]["observed_order"].get<double>(), 2, 0.1);
  EXPECT_NEAR(table["series"][1]["observed_order"].get<double>(), 1, 0.1);
}

TEST_F(Trade, RejectsBadRequests) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"trade projectil", "did you mean 'projectile'"},
      {"trade projectile --engine oed", "ode"},
      {"trade projectile --engine in-house --integrator rk5", "integrators"},
      {"trade projectile --observable energi", "energy"},
      {"trade projectile --dt 0.3", "--dt"},
      {"trade projectile --dt 0.8", "in common"},
      {"trade projectile --engine in-house/gyro=none --rounds 0", "gyro"},
      {"trade projectile --json no/such/folder.json", "folder"}};
  for (const auto& [command, word] : cases) {
    const Ran ran = cylon(command);
    EXPECT_EQ(ran.code, 2) << command << ran.err;
    EXPECT_NE(ran.err.find(word), std::string::npos) << command << '\n' << ran.err;
  }
}

}  // namespace
}  // namespace cylon::cli
