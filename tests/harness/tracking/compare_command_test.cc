// `cylon track compare` and `cylon track gate` as a user meets them.
#include "harness/tracking/track_compare.h"
#include "tests/harness/cli/fixture.h"
#include "tests/paths.h"

#include <nlohmann/json.hpp>

namespace cylon::tracking {

using namespace cli;
namespace {

using results::Finding;

class CompareCommand : public CommandLine {
 protected:
  /// A build folder in which Bullet's worker poses as the in-house one: an engine that has become less
  /// accurate.
  void add_impostor() const {
    std::filesystem::create_directory(folder / "impostor");
    std::filesystem::copy_file(std::string(binary_dir) + "/cylon-worker-bullet-f64",
                               folder / "impostor/cylon-worker-in-house");
  }
};

TEST_F(CompareCommand, ExitCodesAndMessages) {
  add_impostor();
  const std::string build = binary_dir, quick = " projectile --engine in-house --no-time --instructions off";
  const struct {
    std::string arguments;
    int code;
    const char* says;
  } cases[] = {
      {"compare --help", 0, "--baseline-worker"},
      {"gate --help", 0, "Holm"},
      {"compare projectile", 2, "--baseline is missing"},
      {"compare --baseline nosuch projectile", 2, "is no build folder, no binary, no git revision"},
      {"compare --baseline . projectile", 2, "there is no cylon-worker-* in this folder"},
      {"compare --baseline run:7 projectile", 2, "history"},
      {"compare --baseline " + build + " --max-pairs 4", 2, "not in range 8 to 40"},
      {"compare --baseline " + build + " 'zzz*'", 4, "nothing selected"},
      {"compare --baseline " + build + " --candidate nosuch projectile", 2, "--candidate nosuch"},
      {"compare --baseline " + build + quick, 0, "identical"},
      {"gate --strict --baseline " + build + "/cylon" + quick, 0, "1 skipped"},
      {"compare --candidate impostor --baseline " + build + quick, 1, "1 regressed"},
      {"gate --candidate impostor --baseline " + build + quick, 1, "error of"},
      {"gate --baseline impostor" + quick, 0, "1 improved"},
      {"compare --baseline " + build + quick + " --json - --junit -", 2, "'-' is given twice"},
  };
  for (const auto& c : cases) {
    const Ran ran = cylon("track " + c.arguments);
    EXPECT_EQ(ran.code, c.code) << c.arguments << "\n" << ran.out << ran.err;
    EXPECT_NE((ran.out + ran.err).find(c.says), std::string::npos) << c.arguments << "\n"
                                                                   << ran.out << ran.err;
  }
}

TEST_F(CompareCommand, CommandOfCellReproducesIt) {
  add_impostor();
  const Ran ran =
      cylon(std::string("track compare --candidate impostor --no-time --instructions off --baseline ") +
            std::string(binary_dir) + " projectile --engine in-house --dt 1/50 --json - --junit j.xml");
  ASSERT_EQ(ran.code, 1) << ran.err;
  const auto row = nlohmann::json::parse(ran.out).at("cells").at(0);
  EXPECT_EQ(row.at("finding"), "regressed");
  const Ran again = shell(row.at("reproduce").get<std::string>() + " --no-time --instructions off");
  EXPECT_EQ(again.code, 1) << again.err;
  EXPECT_NE(read("j.xml").find("<failure "), std::string::npos);
}

// An engine of the user's own: the older build goes by --baseline-worker.
TEST_F(CompareCommand, ComparesExternalEngineByWorkers) {
  const std::string engine = std::string(source_dir) + "/docs/examples/foreign_engine.py";
  write("new.py", replaced(read(engine), "import", "# the newer build\nimport"));
  const std::string words =
      "track gate --instructions off --no-time projectile --engine mine --worker 'mine=python3 " +
      (folder / "new.py").string() + "' ";
  const Ran ran = cylon(words + "--baseline-worker 'mine=python3 " + engine + "' --markdown -");
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("1 same"), std::string::npos) << ran.out;
  EXPECT_EQ(cylon(words).code, 2);  // compared with what?
}

TEST_F(CompareCommand, ComparesResultsWithStoredRun) {
  ASSERT_EQ(cylon("track record projectile --engine in-house --label before").code, 0);
  add_impostor();
  const std::string quick = " projectile --engine in-house --instructions off";
  const Ran same = cylon("track compare --baseline run:before" + quick);
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  EXPECT_NE(same.out.find("1 same"), std::string::npos) << same.out;
  EXPECT_NE(same.out.find("times are not compared with a stored run"), std::string::npos) << same.out;
  EXPECT_EQ(cylon("track compare --baseline before --candidate impostor" + quick).code, 1);
  write("projectile.toml", replaced(shipped("projectile"), "mass     = 1.0", "mass     = 1.5"));
  const Ran other =
      cylon("track compare --baseline before projectile.toml --engine in-house --instructions off");
  EXPECT_NE(other.out.find("another version of the scenario"), std::string::npos) << other.out << other.err;
}

// A gate against a run that lacks its cells skipped them all and exited with 0, --strict or not.
TEST_F(CompareCommand, GateThatComparesNothingIsNotGreen) {
  ASSERT_EQ(cylon("track record projectile --engine in-house --label before").code, 0);
  const std::string gate = "track gate --baseline run:before --engine in-house --instructions off ";
  for (const char* words : {"heavy_top", "heavy_top --strict"}) {
    const Ran ran = cylon(gate + words);
    EXPECT_EQ(ran.code, 4) << words << ran.out << ran.err;
    EXPECT_NE(ran.err.find("nothing compared: 1 of 1 cells skipped; heavy_top/in-house"), std::string::npos)
        << ran.err;
    EXPECT_NE(ran.err.find("the stored run has no such cell"), std::string::npos) << ran.err;
  }
  EXPECT_EQ(cylon(gate + "projectile heavy_top").code, 0);
  EXPECT_EQ(cylon(gate + "projectile heavy_top --strict").code, 3);
  EXPECT_EQ(cylon(gate + "projectile --strict").code, 0);
}

// A revision is built in a worktree by the preset `release` and the name of the worker alone, so that a
// repository of a few lines will do: its revision v1 has the in-house worker, and not ODE's; v2 cannot be
// built.
TEST_F(CompareCommand, BuildsRevisionOnce) {
  std::filesystem::create_directories(folder / "repo/scenarios");
  write("repo/scenarios/projectile.toml", shipped("projectile"));
  write("repo/CMakePresets.json",
        R"({"version": 5, "configurePresets": [{"name": "release", "generator": "Ninja"}]})");
  const std::string project =
      "cmake_minimum_required(VERSION 3.25)\nproject(small LANGUAGES NONE)\n"
      "add_custom_target(cylon-worker-in-house COMMAND ${CMAKE_COMMAND} -E copy " +
      std::string(binary_dir) + "/cylon-worker-bullet-f64 ${CMAKE_BINARY_DIR}/cylon-worker-in-house)\n";
  write("repo/CMakeLists.txt", project);
  const std::string git = "git -C repo -c user.name=n -c user.email=e ";
  const std::string commit = git + "add . && " + git + "commit -q -m change";
  ASSERT_EQ(shell("git init -q repo && " + commit + " && git -C repo tag v1").code, 0);
  write("repo/CMakeLists.txt", replaced(project, "COMMAND", "COMMAND false COMMAND"));
  ASSERT_EQ(shell(commit + " && git -C repo tag v2").code, 0);

  const std::string compare =
      "CYLON_SCENARIOS=repo/scenarios cylon track compare projectile --no-time --instructions off "
      "--engine in-house --engine ode --baseline ";
  const Ran first = shell(compare + "v1"), again = shell(compare + "v1"), broken = shell(compare + "v2");
  EXPECT_EQ(first.code, 0) << first.out << first.err;
  EXPECT_NE(first.out.find("1 improved, 1 skipped"), std::string::npos) << first.out << first.err;
  EXPECT_NE(first.err.find("checking out v1"), std::string::npos) << first.err;
  EXPECT_EQ(again.out, first.out);
  EXPECT_EQ(again.err.find("checking out"), std::string::npos) << again.err;
  EXPECT_EQ(broken.code, 2) << broken.out << broken.err;
  EXPECT_NE(broken.err.find("cylon-worker-in-house cannot be built, see "), std::string::npos) << broken.err;
}

TEST(ExitCode, InconclusiveFailsOnlyWithStrict) {
  const auto with = [](Finding finding, bool reliable) {
    results::ComparisonReport report;
    report.reliable = reliable;
    report.cells.emplace_back().finding = finding;
    return report;
  };
  const struct {
    Finding finding;
    bool reliable, strict;
    int code;
  } cases[] = {{Finding::same, true, true, 0},          {Finding::improved, true, true, 0},
               {Finding::changed, true, true, 0},       {Finding::improved, false, true, 3},
               {Finding::inconclusive, true, false, 0}, {Finding::inconclusive, true, true, 3},
               {Finding::same, false, false, 0},        {Finding::same, false, true, 3},
               {Finding::regressed, true, false, 1},    {Finding::regressed, false, true, 1}};
  for (const auto& c : cases)
    EXPECT_EQ(exit_code(with(c.finding, c.reliable), c.strict), c.code)
        << results::name(c.finding) << c.reliable << c.strict;
}

// A gate whose cells were all skipped was green.
TEST(ExitCode, NothingComparedIsNotGreen) {
  using results::Skip;
  const struct {
    std::vector<Skip> cells;
    int code, strict;
  } cases[] = {{{Skip::identical}, 0, 0},
               {{Skip::missing}, 4, 4},
               {{Skip::unsupported, Skip::missing}, 4, 4},
               {{Skip::unsupported, Skip::identical}, 0, 0},
               {{Skip::missing, Skip::identical}, 0, 3},
               {{Skip::missing, Skip::none}, 0, 3},
               {{Skip::unsupported, Skip::none}, 0, 0}};
  for (const auto& c : cases) {
    results::ComparisonReport report;
    for (const Skip skip : c.cells) {
      results::Comparison& cell = report.cells.emplace_back();
      cell.finding = skip == Skip::none ? Finding::same : Finding::skipped, cell.skip = skip;
    }
    EXPECT_EQ(exit_code(report, false), c.code) << &c - cases;
    EXPECT_EQ(exit_code(report, true), c.strict) << &c - cases;
  }
}

}  // namespace
}  // namespace cylon::tracking
