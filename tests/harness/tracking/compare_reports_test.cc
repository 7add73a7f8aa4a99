// Comparisons as JUnit, Markdown, JSON and text, with names that contain markup.
#include "reports/comparison_report.h"
#include "reports/markdown.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace cylon::reports {
namespace {

using results::Comparison;
using results::ComparisonReport;
using results::Finding;

const std::string hostile = "a|b</td><script>&\"'\n| x | [l](https://e.x) @all #1 `c` \x1b[31m \xff ]]>";

Comparison cell(Finding finding) {
  Comparison c;
  c.scenario = hostile, c.engine = hostile, c.dt_text = "1/60", c.dt = 1.0 / 60;
  c.finding = finding;
  c.reproduce = "cylon track compare '" + hostile + "'";
  c.metrics = {{"error of " + hostile, finding, "rose by 25 %"}};
  c.time.emplace();
  c.time->finding = finding, c.time->ratio = 1.0525, c.time->low = 1.0469, c.time->high = 1.0581;
  c.time->pairs = 16, c.time->what = "800 steps, least of 8 x 30 runs";
  return c;
}

ComparisonReport report() {
  ComparisonReport r;
  r.baseline = hostile, r.candidate = "this build", r.tau = 0.02, r.alpha = 0.01, r.gate = true;
  r.notes = {hostile};
  for (const Finding f : {Finding::same, Finding::regressed, Finding::inconclusive, Finding::improved,
                          Finding::changed, Finding::skipped})
    r.cells.push_back(cell(f));
  r.cells.back().reason = "identical: " + hostile;
  r.cells.back().time.reset();
  return r;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++n;
  return n;
}

TEST(ComparisonReports, JunitCountsAndEscapes) {
  const std::string xml = to_junit(report());
  EXPECT_NE(xml.find("tests=\"6\" failures=\"1\" errors=\"0\" skipped=\"2\""), std::string::npos) << xml;
  EXPECT_EQ(count(xml, "<failure "), 1u);
  EXPECT_EQ(count(xml, "<skipped "), 2u);
  EXPECT_EQ(count(xml, "<system-out>"), 3u);
  EXPECT_EQ(count(xml, "<testcase "), count(xml, "</testcase>"));
  EXPECT_EQ(xml.find("<script"), std::string::npos);
  EXPECT_EQ(xml.find("]]>"), std::string::npos);
  EXPECT_EQ(xml.find('\x1b'), std::string::npos);
  EXPECT_EQ(xml.find('\xff'), std::string::npos);
  EXPECT_NE(xml.find("x 1.052 (1.047 … 1.058)"), std::string::npos) << xml;
}

TEST(ComparisonReports, MarkdownEscapesTableAndMentions) {
  const std::string text = to_markdown(report());
  EXPECT_EQ(text.find("<script"), std::string::npos);
  EXPECT_EQ(text.find("</td>"), std::string::npos);
  EXPECT_EQ(text.find('@'), std::string::npos);
  EXPECT_EQ(text.find("https://"), std::string::npos);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  // Every row of a table has its five cells: no name has opened a sixth, or another line.
  std::istringstream lines(text);
  int rows = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() != '|') continue;
    ++rows;
    std::size_t bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i) bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\');
    EXPECT_EQ(bars, 6u) << line;
  }
  EXPECT_EQ(rows, 2 * 2 + 6);  // two tables with head and rule, six cells
  EXPECT_NE(text.find("regression confirmed"), std::string::npos);
  EXPECT_LT(text.find("regressed |"), text.find("improved |"));
}

TEST(ComparisonReports, HeadlinesFollowTheFindings) {
  ComparisonReport r = report();
  std::erase_if(r.cells, [](const Comparison& c) { return c.finding == Finding::regressed; });
  EXPECT_NE(to_markdown(r).find("some cells inconclusive"), std::string::npos);
  std::erase_if(r.cells, [](const Comparison& c) { return c.finding == Finding::inconclusive; });
  EXPECT_NE(to_markdown(r).find("Cylon: no regression\n"), std::string::npos);
  EXPECT_EQ(summary(r), "1 improved, 1 changed, 1 same, 1 skipped");
  r.reliable = false;
  r.self_check.emplace();
  r.self_check->ratio = 1.2;
  for (const std::string& text : {to_markdown(r), console(r, {}), warning(r)})
    EXPECT_NE(text.find("environment unreliable"), std::string::npos) << text;
}

TEST(ComparisonReports, JsonIsCompleteAndTextIsEscaped) {
  ComparisonReport r = report();
  r.cells[0].time->ratio = std::numeric_limits<double>::quiet_NaN();
  const auto json = nlohmann::json::parse(to_json(r));
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("cells").size(), 6u);
  EXPECT_TRUE(json.at("cells")[0].at("time").at("ratio").is_null());
  EXPECT_EQ(json.at("cells")[1].at("finding"), "regressed");
  const std::string text = console(r, {.width = 80, .utf8 = false, .colour = false});
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_NE(text.find("1 regressed, 1 inconclusive, 1 improved, 1 changed, 1 same, 1 skipped"),
            std::string::npos);
}

TEST(ComparisonReports, ReportsEmptyComparison) {
  const ComparisonReport none;
  EXPECT_NE(to_junit(none).find("tests=\"0\""), std::string::npos);
  EXPECT_NE(to_markdown(none).find("nothing was compared"), std::string::npos);
}

}  // namespace
}  // namespace cylon::reports
