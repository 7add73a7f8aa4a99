// SIGINT and SIGTERM while engines run: exit code 130, what is done is written, and no half of anything.
#include "tests/harness/cli/fixture.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace cylon::cli {
namespace {

using nlohmann::json;

class Interruption : public CommandLine {
 protected:
  static std::string worker(const std::string& name, const std::string& mode,
                            const std::string& option = "--worker") {
    return " " + option + " '" + name + "=python3 " + std::string(source_dir) +
           "/tests/harness/process/scripted_worker.py " + mode + "'";
  }
  // An engine that tells that it is at work, and then never ends.
  static std::string slow(const std::string& at = "run") { return worker("slow", "says_and_loops_in_" + at); }
  // The signal once that engine runs.
  Ran at_work(const std::string& arguments, int signal = SIGINT) const {
    return shell(
        "exec cylon " + arguments, [&] { return std::filesystem::exists(folder / "at_work"); }, signal);
  }
  bool nothing_but(const std::vector<std::string>& names) const {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string name = entry.path().filename();
      if (!name.starts_with('.') && std::ranges::find(names, name) == names.end()) return false;
    }
    return true;
  }
};

// One result: there is none, and no file.
TEST_F(Interruption, OfOneResultLeavesNoFile) {
  for (const std::string& command :
       {"simulate projectile --engine slow --out s.csv" + slow(),
        "diff projectile in-house slow --csv d.csv" + slow(), "plan projectile --engine slow" + slow("load"),
        "advise projectile --engine slow --json a.json" + slow()}) {
    const Ran ran = at_work(command);
    EXPECT_EQ(ran.code, 130) << command << ran.err;
    EXPECT_TRUE(ran.err.ends_with("interrupted\n")) << command << ran.err;
    EXPECT_EQ(ran.out, "") << command;
    EXPECT_TRUE(nothing_but({"at_work"})) << command;
    std::filesystem::remove(folder / "at_work");
  }
}

TEST_F(Interruption, BySigterm) {
  const Ran ran = at_work("simulate projectile --engine slow --out s.csv" + slow(), SIGTERM);
  EXPECT_EQ(ran.code, 130) << ran.err;
  EXPECT_EQ(ran.err, "interrupted\n");
  EXPECT_TRUE(nothing_but({"at_work"}));
}

// The search that is done is in both reports, and is not searched again.
TEST_F(Interruption, OfLimitsKeepsSearches) {
  const std::string command = "limits --engine in-house --engine ode -j 1 --json l.json --csv l.csv";
  const Ran ran = shell("exec cylon " + command, [&] {
    return read(".cylon/limits.jsonl").find("\"cell\":\"stiffness") != std::string::npos;
  });
  EXPECT_EQ(ran.code, 130) << ran.err;
  EXPECT_NE(ran.err.find("interrupted: what is written holds the searches that are done"), std::string::npos)
      << ran.err;
  const json rows = json::parse(read("l.json")).at("limits");
  ASSERT_GE(rows.size(), 3u);
  EXPECT_EQ(rows[0].at("family"), "spring");
  EXPECT_EQ(rows[0].at("engine"), "in-house");
  EXPECT_EQ(rows[1].at("engine"), "ode");
  EXPECT_NE(read("l.csv").find("spring,ode,"), std::string::npos);
  EXPECT_NE(ran.out.find("spring: largest w dt"), std::string::npos) << ran.out;
}

TEST_F(Interruption, OfVerifiedAdviceSaysHowToGoOn) {
  const Ran ran = at_work("advise projectile --verify --engine slow" + slow());
  EXPECT_EQ(ran.code, 130) << ran.err;
  EXPECT_NE(ran.err.find("interrupted: "), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("--resume"), std::string::npos) << ran.err;
  EXPECT_NE(ran.out.find("0 results"), std::string::npos) << ran.out;
  const Ran refused = cylon("advise projectile --verify --json a.json");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("--json"), std::string::npos) << refused.err;
}

// The cell that was compared is in the reports; the other is skipped, with the reason.
TEST_F(Interruption, OfComparisonsKeepsCells) {
  for (const char* word : {"compare", "gate"}) {
    const Ran ran =
        at_work(std::string("track ") + word +
                " projectile --engine one --engine slow --no-time --instructions off --json c.json "
                "--junit c.xml" +
                worker("one", "good") + worker("one", "well", "--baseline-worker") + slow() +
                worker("slow", "good", "--baseline-worker"));
    EXPECT_EQ(ran.code, 130) << word << ran.err;
    EXPECT_NE(ran.err.find("interrupted: the reports hold what is compared"), std::string::npos) << ran.err;
    const json cells = json::parse(read("c.json")).at("cells");
    ASSERT_EQ(cells.size(), 2u) << word;
    EXPECT_NE(cells[0].at("finding"), "skipped") << word << cells[0];
    EXPECT_EQ(cells[1].at("finding"), "skipped") << word << cells[1];
    EXPECT_EQ(cells[1].at("reason"), "interrupted before it was compared") << word;
    EXPECT_NE(read("c.xml").find("interrupted before it was compared"), std::string::npos) << word;
    std::filesystem::remove(folder / "at_work");
  }
}

// `trade` and `matrix` write the scenario that is done.
TEST_F(Interruption, OfSweepsKeepsScenarios) {
  write("a.toml", shipped("projectile"));
  write("b.toml", shipped("projectile"));
  const std::string commands[] = {
      "trade a.toml b.toml --engine in-house --integrator rk4 --steps 3 --rounds 10 --json t.json",
      "matrix a.toml b.toml --engine in-house --finest 1e-2 --rounds 10 --json t.json"};
  for (const std::string& command : commands) {
    std::filesystem::remove_all(folder / ".cylon");
    const std::string journal = ".cylon/" + command.substr(0, command.find(' ')) + ".jsonl";
    const Ran ran = shell("exec cylon " + command,
                          [&] { return read(journal).find("\"cell\":\"a\"") != std::string::npos; });
    EXPECT_EQ(ran.code, 130) << command << ran.err;
    const json tables = json::parse(read("t.json")).at("tables");
    ASSERT_EQ(tables.size(), 1u) << command;
    EXPECT_EQ(tables[0].at("scenario"), "a");
  }
}

// While files are read nothing can be told: the signal ends the program.
TEST_F(Interruption, WhileLoadingIsByDefault) {
  const Ran ran =
      shell("mkfifo wait; timeout --preserve-status -s TERM 1 cylon diff projectile in-house wait.csv", {});
  EXPECT_NE(ran.code, 130) << ran.err;
}

}  // namespace
}  // namespace cylon::cli
