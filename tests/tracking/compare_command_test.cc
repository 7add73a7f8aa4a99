// `cylon track compare` and `cylon track gate` as a user meets them.
#include "harness/cli/track_compare.h"
#include "tests/harness/cli_fixture.h"

#include <nlohmann/json.hpp>

namespace cylon::cli {
namespace {

using core::Finding;

class CompareCommand : public CommandLine {
 protected:
  /// A build folder in which Bullet's worker poses as the in-house one: an engine that has become less
  /// accurate.
  void add_impostor() const {
    std::filesystem::create_directory(folder / "impostor");
    std::filesystem::copy_file(CYLON_BINARY_DIR "/cylon-worker-bullet-f64",
                               folder / "impostor/cylon-worker-in-house");
  }
};

TEST_F(CompareCommand, ExitCodesAndMessages) {
  add_impostor();
  const std::string build = CYLON_BINARY_DIR,
                    quick = " projectile --engine in-house --no-time --instructions off";
  const struct {
    std::string arguments;
    int code;
    const char* says;
  } cases[] = {
      {"compare --help", 0, "--baseline-worker"},
      {"gate --help", 0, "Holm"},
      {"compare projectile", 2, "say what to compare with"},
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

TEST_F(CompareCommand, TheCommandOfACellComparesItAgain) {
  add_impostor();
  const Ran ran =
      cylon(std::string("track compare --candidate impostor --no-time --instructions off --baseline ") +
            CYLON_BINARY_DIR + " projectile --engine in-house --dt 1/50 --json - --junit j.xml");
  ASSERT_EQ(ran.code, 1) << ran.err;
  const auto row = nlohmann::json::parse(ran.out).at("cells").at(0);
  EXPECT_EQ(row.at("finding"), "regressed");
  const Ran again = shell(row.at("reproduce").get<std::string>() + " --no-time --instructions off");
  EXPECT_EQ(again.code, 1) << again.err;
  EXPECT_NE(read("j.xml").find("<failure "), std::string::npos);
}

// An engine of the user's own: the older build goes by --baseline-worker.
TEST_F(CompareCommand, AnEngineElsewhereIsComparedByItsWorkers) {
  const std::string engine = CYLON_SOURCE_DIR "/docs/examples/foreign_engine.py";
  write("new.py", replaced(read(engine), "import", "# the newer build\nimport"));
  const std::string words =
      "track gate --instructions off --no-time projectile --engine mine --worker 'mine=python3 " +
      (folder / "new.py").string() + "' ";
  const Ran ran = cylon(words + "--baseline-worker 'mine=python3 " + engine + "' --markdown -");
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("1 same"), std::string::npos) << ran.out;
  EXPECT_EQ(cylon(words).code, 2);  // compared with what?
}

TEST_F(CompareCommand, AStoredRunIsComparedInItsResults) {
  ASSERT_EQ(cylon("track record projectile --engine in-house --label before").code, 0);
  add_impostor();
  const std::string quick = " projectile --engine in-house --instructions off";
  const Ran same = cylon("track compare --baseline run:before" + quick);
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  EXPECT_NE(same.out.find("1 same"), std::string::npos) << same.out;
  EXPECT_NE(same.out.find("times are not compared with a past moment"), std::string::npos) << same.out;
  EXPECT_EQ(cylon("track compare --baseline before --candidate impostor" + quick).code, 1);
  write("projectile.toml", replaced(shipped("projectile"), "mass     = 1.0", "mass     = 1.5"));
  const Ran other =
      cylon("track compare --baseline before projectile.toml --engine in-house --instructions off");
  EXPECT_NE(other.out.find("another version of the scenario"), std::string::npos) << other.out << other.err;
}

TEST(ExitCode, InconclusiveCountsWhereItIsAskedFor) {
  const auto with = [](Finding finding, bool reliable) {
    core::ComparisonReport report;
    report.reliable = reliable;
    report.cells.emplace_back().finding = finding;
    return report;
  };
  const struct {
    Finding finding;
    bool reliable, strict;
    int code;
  } cases[] = {{Finding::same, true, true, 0},          {Finding::improved, true, true, 0},
               {Finding::changed, true, true, 0},       {Finding::skipped, true, true, 0},
               {Finding::inconclusive, true, false, 0}, {Finding::inconclusive, true, true, 3},
               {Finding::same, false, false, 0},        {Finding::same, false, true, 3},
               {Finding::regressed, true, false, 1},    {Finding::regressed, false, true, 1}};
  for (const auto& c : cases)
    EXPECT_EQ(exit_code(with(c.finding, c.reliable), c.strict), c.code)
        << core::name(c.finding) << c.reliable << c.strict;
}

}  // namespace
}  // namespace cylon::cli
