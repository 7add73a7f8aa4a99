// `cylon run --html`, `--traces` and `cylon report` on the engines that are built here.
#include "reports/gzip.h"
#include "tests/harness/cli/fixture.h"

#include <nlohmann/json.hpp>

namespace cylon::cli {
namespace {

using nlohmann::json;

json index_of(const std::string& page) {
  const std::string open = "id=\"block-0\">";
  const std::size_t begin = page.find(open) + open.size(), end = page.find("</script>", begin);
  return json::parse(reports::gunzip(reports::from_base64(page.substr(begin, end - begin)), 1 << 28));
}

TEST_F(CommandLine, ReportOfRunHasTracePerCell) {
  const Ran ran = cylon("run projectile spring_orbit --engine in-house --engine ode --html r.html");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const json index = index_of(read("r.html"));
  EXPECT_EQ(index["traces"].size(), 4u);
  EXPECT_EQ(index["scenarios"].size(), 2u);
  EXPECT_EQ(index["scenarios"][0]["scene"]["body"].size(), 1u);
  EXPECT_EQ(index["omitted_traces"], "");
  for (const json& trace : index["traces"]) {
    bool found = false;
    for (const json& row : index["results"]["verdicts"])
      found |= row["scenario"] == trace["scenario"] && row["engine"] == trace["engine"] &&
               row["integrator"] == trace["integrator"] && row["dt_text"] == trace["dt_text"];
    EXPECT_TRUE(found) << trace;
  }
}

TEST_F(CommandLine, ReportFromFilesIsThatOfTheRun) {
  ASSERT_EQ(cylon("run projectile spring_orbit --engine in-house --engine ode --html a.html --json v.json "
                  "--traces t.jsonl -j 2")
                .code,
            0);
  const Ran ran = cylon("report t.jsonl v.json --html b.html");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(read("a.html"), read("b.html"));
  ASSERT_EQ(shell("cylon report t.jsonl - --html c.html < v.json").code, 0);
  EXPECT_EQ(read("a.html"), read("c.html"));
}

TEST_F(CommandLine, ReportKnowsTheScenariosOfItsVerdicts) {
  ASSERT_EQ(cylon("run projectile --engine in-house --json v.json").code, 0);
  ASSERT_EQ(cylon("report v.json --html r.html --baseline v.json --title 'of <b>today</b>'").code, 0);
  const std::string page = read("r.html");
  const json index = index_of(page);
  EXPECT_EQ(index["scenarios"][0]["name"], "projectile");
  EXPECT_EQ(index["omitted_traces"], "no file of `cylon run --traces` was given");
  EXPECT_FALSE(index["baseline"].is_null());
  EXPECT_NE(page.find("<title>of &lt;b&gt;today&lt;/b&gt;</title>"), std::string::npos);
  const json listed = json::parse(cylon("list projectile --json").out)[0];
  for (const auto& [key, value] : listed.items()) EXPECT_EQ(index["scenarios"][0][key], value) << key;
  EXPECT_EQ(listed["claims"][0]["label"], index["results"]["verdicts"][0]["claim"]);
}

// gyro=none fails on purpose: of that scenario all runs are kept, of the other none.
TEST_F(CommandLine, ReportKeepsFailuresAndWhatTheyAreComparedWith) {
  const std::string cells = "run dzhanibekov projectile --engine in-house --engine bullet/gyro=none ";
  ASSERT_EQ(cylon(cells + "--html r.html --trajectories fail").code, 1);
  const json index = index_of(read("r.html"));
  std::vector<std::string> kept;
  for (const json& trace : index["traces"]) kept.push_back(trace["engine"]);
  ASSERT_GE(kept.size(), 2u);
  EXPECT_EQ(kept.front(), "bullet/gyro=none") << "failures first";
  ASSERT_EQ(cylon(cells + "--html n.html --trajectories none").code, 1);
  EXPECT_EQ(index_of(read("n.html"))["traces"].size(), 0u);
}

TEST_F(CommandLine, ReportOfAnEngineThatCrashesSaysThatThereIsNoRecording) {
  const Ran ran =
      cylon("run projectile --engine in-house --engine broken --worker 'broken=/bin/false' --html r.html");
  EXPECT_EQ(ran.code, 5) << ran.err;
  const json index = index_of(read("r.html"));
  EXPECT_EQ(index["traces"].size(), 1u);
  EXPECT_NE(index["omitted_traces"].get<std::string>().find("1 cells have no recording"), std::string::npos)
      << index["omitted_traces"];
}

TEST_F(CommandLine, ReportReadsDocumentsOfOtherCommands) {
  ASSERT_EQ(cylon("trade projectile --engine in-house --json trade.json --html trade.html --work 4096").code,
            0);
  EXPECT_EQ(index_of(read("trade.html"))["trades"][0], json::parse(read("trade.json")));
  EXPECT_TRUE(index_of(read("trade.html"))["results"].is_null());
  write("history.json", R"({"schema":1,"series":[]})");
  write("compare.json", R"({"schema":1,"baseline":"a","candidate":"b","cells":[]})");
  const Ran ran = cylon("report compare.json trade.json history.json --html r.html");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const json index = index_of(read("r.html"));
  EXPECT_EQ(index["trades"].size(), 1u);
  EXPECT_EQ(index["comparisons"].size(), 1u);
  EXPECT_EQ(index["histories"].size(), 1u);
}

TEST_F(CommandLine, ReportRefusals) {
  ASSERT_EQ(cylon("run projectile --engine in-house --json v.json").code, 0);
  write("empty", "");
  write("other.json", "{\"a\": 1}");
  write("half.json", read("v.json").substr(0, 300));
  write("line.jsonl", "{\"format\":\"cylon-trace/1\"}\n");
  write("nameless.jsonl", "{\"format\":\"cylon-scenario/1\",\"name\":7}\n");
  const struct {
    const char *arguments, *says;
  } cases[] = {
      {"nameless.jsonl v.json --html r.html", "nameless.jsonl:1: a scenario without its \"name\""},
      {"nothing.json --html r.html", "nothing.json: cannot be read"},
      {". --html r.html", ".: cannot be read"},
      {"empty --html r.html", "empty: not JSON at byte 1"},
      {"half.json --html r.html", "half.json: not JSON at byte 301"},
      {"other.json --html r.html", "other.json: not a document of Cylon"},
      {"line.jsonl --html r.html", "line.jsonl:1: "},
      {"v.json v.json --html r.html", "v.json: a report takes one file of verdicts"},
      {"v.json --html no/folder/r.html", "no/folder/r.html"},
      {"v.json --baseline other.json --html r.html", "other.json"},
      {". --html r.html", ".: "},
  };
  for (const auto& c : cases) {
    const Ran ran = cylon(std::string("report ") + c.arguments);
    EXPECT_EQ(ran.code, 2) << c.arguments;
    EXPECT_NE(ran.err.find(c.says), std::string::npos) << c.arguments << ": " << ran.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "r.html")) << c.arguments;
  }
}

TEST_F(CommandLine, ReportWithoutHtmlPrintsMatrix) {
  ASSERT_EQ(cylon("run projectile --engine in-house --json v.json").code, 0);
  const Ran ran = cylon("report v.json");
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.out.find("projectile"), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace cylon::cli
