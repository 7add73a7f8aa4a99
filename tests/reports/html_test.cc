// The page as bytes: complete, hardened against what it shows, the same for the same report.
#include "reports/html.h"

#include "reports/gzip.h"
#include "reports/web_bundle.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace cylon::reports {
namespace {

using nlohmann::json;

constexpr const char* hostile = "</script><script>alert(1)</script>\x1b[2J\"'&\xff";

results::Verdict row(const std::string& scenario, const std::string& engine) {
  results::Verdict v;
  v.scenario = scenario, v.engine = engine, v.integrator = "rk4", v.dt_text = "0.01", v.dt = 0.01;
  v.claim = "energy", v.measured = 1, v.allowed = 10, v.status = results::Status::pass;
  return v;
}

json index_of(const std::string& page) {
  const std::string open = "id=\"block-0\">";
  const std::size_t begin = page.find(open) + open.size(), end = page.find("</script>", begin);
  return json::parse(gunzip(from_base64(page.substr(begin, end - begin)), 1 << 28));
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

TEST(Html, HoldsItsDocuments) {
  HtmlReport report;
  report.results = RunReport{{}, {row("top", "in-house")}};
  report.documents["trades"] = {
      {{"format", "cylon-trade/1"}, {"tables", json::array()}, {"times", json::array()}}};
  const json index = index_of(to_html(report));
  EXPECT_EQ(index["results"]["verdicts"][0]["scenario"], "top");
  EXPECT_EQ(index["trades"].size(), 1u);
  EXPECT_TRUE(index["baseline"].is_null());
  EXPECT_EQ(to_html(report), to_html(report));
}

// Foreign text stands in packed blocks, in the title and in the plain table, and nowhere as markup.
TEST(Html, EscapesHostileText) {
  HtmlReport report;
  report.title = hostile;
  results::Verdict v = row(hostile, hostile);
  v.complaints = std::string(1 << 20, '<') + hostile;
  v.detail = hostile;
  report.results = RunReport{{}, {v}};
  report.traces = {{hostile, hostile, hostile, hostile, base64(gzip("x"))}};
  report.omitted_traces = hostile;
  const std::string page = to_html(report);
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  EXPECT_EQ(page.find('\x1b'), std::string::npos);
  EXPECT_EQ(count(page, "<script"), 3u + count(std::string(web::script()), "<script"))
      << "two blocks and the script";
  EXPECT_EQ(index_of(page)["results"]["verdicts"][0]["detail"].get<std::string>().substr(0, 9), "</script>");
}

TEST(Html, NeedsNoNetworkAndHasOneScript) {
  const std::string page = to_html({});
  EXPECT_NE(page.find("default-src 'none'; script-src '" + std::string(web::script_hash()) + "'"),
            std::string::npos);
  for (const char* word : {"<link", "src=\"http", "@import", "url(http"})
    EXPECT_EQ(page.find(word), std::string::npos) << word;
  EXPECT_EQ(web::script().find("</script"), std::string_view::npos);
}

TEST(Html, MatrixIsReadableWithoutScript) {
  HtmlReport report;
  results::Verdict bad = row("top", "ode");
  bad.measured = 100, bad.status = results::Status::fail;
  report.results = RunReport{{}, {row("top", "in-house"), bad}};
  const std::string page = to_html(report);
  EXPECT_NE(page.find("<th scope=\"row\">top</th><td>✓ +1.0</td><td>✗ -1.0 !</td>"), std::string::npos);
  // One scenario at two steps is one.
  bad.dt = 0.02, bad.dt_text = "0.02";
  report.results->verdicts.push_back(bad);
  EXPECT_NE(to_html(report).find("<title>Cylon: 1 scenario on 2 engines</title>"), std::string::npos);
}

json two_engines() {
  return {{"format", "cylon-trade/1"},
          {"times", json::array()},
          {"tables",
           {{{"scenario", "top"},
             {"series",
              {{{"engine", hostile}, {"closed_form", true}, {"points", {{{"dt", 0.1}}}}},
               {{"engine", "ode"},
                {"closed_form", false},
                {"substeps", 4},
                {"points", {{{"dt", 0.1}}, {{"dt", 0.002}}}}}}},
             {"cells",
              {{{"series", 0}, {"refusal", ""}, {"reach", {{{"error", 0.01}, {"point", 0}}}}},
               {{"series", 1},
                {"refusal", ""},
                {"reach",
                 {{{"error", 0.01}, {"point", 1}, {"why", ""}},
                  {{"error", 0.001}, {"point", nullptr}, {"why", "no order"}}}}}}}}}}};
}

// Which step an engine needs stands before digits at a step.
TEST(Html, OpensWithTheMatrixOfStepsWithoutScript) {
  HtmlReport report;
  report.results = RunReport{{}, {row("top", "in-house")}};
  report.documents["trades"] = {two_engines()};
  const std::string page = to_html(report);
  const auto steps = page.find(
      "<th scope=\"row\">ode</th><td>1e-02: 2 ms (4 substeps)</td><td>1e-03: not reached</td><td>no "
      "order</td>");
  ASSERT_NE(steps, std::string::npos);
  EXPECT_LT(steps, page.find("<th scope=\"row\">top</th><td>✓ +1.0</td>"));
  EXPECT_NE(page.find("<td>1e-02: no steps</td>"), std::string::npos);
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  for (const json& part :
       {json(3), json("x"), json::array({1, "y", nullptr, -1, 1e300}), json{{"a", 1}}, json()}) {
    for (const char* key : {"series", "cells", "scenario"}) {
      HtmlReport odd;
      odd.documents["trades"] = {two_engines()};
      odd.documents["trades"][0]["tables"][0][key] = part;
      EXPECT_NE(to_html(odd).find("</html>"), std::string::npos) << part;
      for (const char* of_cell : {"series", "refusal", "reach"}) {
        odd.documents["trades"] = {two_engines()};
        odd.documents["trades"][0]["tables"][0]["cells"][1][of_cell] = part;
        EXPECT_NE(to_html(odd).find("</html>"), std::string::npos) << part;
      }
    }
  }
}

TEST(Html, ScoresOfMeasuredMotionsAreReadableWithoutScript) {
  const auto estimate = [](double value) {
    return json{{"value", value}, {"low", value / 2}, {"high", 2 * value}, {"runs", 7}};
  };
  HtmlReport report;
  report.documents["predictions"] = {
      {{"format", "cylon-prediction/1"},
       {"title", hostile},
       {"source", hostile},
       {"licence", "MIT"},
       {"coordinates", "free"},
       {"engines", {{{"engine", "ode"}, {"distance", estimate(0.024)}, {"band", "undecided"}}}}},
      {{"format", "cylon-prediction/1"},
       {"title", "arms"},
       {"coordinates", "chain"},
       {"engines", {{{"engine", hostile}, {"held", {{"value", 0.5}, {"low", 0.25}, {"high", nullptr}}}}}}}};
  report.documents["fits"] = {
      {{"format", "cylon-fit/1"},
       {"fits",
        {{{"engine", "bullet"},
          {"parameters", {{{"name", "friction"}, {"value", 0.2}, {"low", 0.1}, {"high", 0.3}}}}}}}}};
  const std::string page = to_html(report);
  EXPECT_NE(page.find("<th scope=\"row\">ode</th><td>24.0 [12.0, 48.0]</td>"), std::string::npos);
  EXPECT_NE(page.find("<td>undecided</td>"), std::string::npos);
  EXPECT_NE(page.find("<td>0.500 [0.250, the end]</td>"), std::string::npos);
  EXPECT_NE(page.find("<td>friction</td><td>0.2 [0.1, 0.3]</td>"), std::string::npos);
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  // What is of another form than the commands write breaks no page.
  for (const json& part : {json(3), json("x"), json::array({1, "y", nullptr}), json{{"a", 1}}, json()}) {
    HtmlReport odd;
    odd.documents["predictions"] = {{{"format", "cylon-prediction/1"}, {"title", part}, {"engines", part}}};
    odd.documents["fits"] = {{{"format", "cylon-fit/1"}, {"fits", part}}};
    EXPECT_NE(to_html(odd).find("<h2>"), std::string::npos) << part;
  }
}

// Of fewer than six runs a median has no interval, which was printed as one that goes to the end of the data.
TEST(Html, ScoresWithoutScriptSayNoMoreThanTheDocument) {
  const auto estimate = [](json value, int runs) {
    return json{{"value", std::move(value)}, {"low", nullptr}, {"high", nullptr}, {"runs", runs}};
  };
  HtmlReport report;
  report.documents["predictions"] = {
      {{"format", "cylon-prediction/1"},
       {"coordinates", "chain"},
       {"members", 0},
       {"engines",
        {{{"engine", "ode"},
          {"runs", 3},
          {"failed", 0},
          {"held", estimate(0.57, 3)},
          {"expected", estimate(nullptr, 3)},
          {"exponent", estimate(nullptr, 0)},
          {"band", "undecided"}},
         {{"engine", "bullet"}, {"runs", 3}, {"failed", 3}, {"first_failure", hostile}}}}}};
  report.documents["fits"] = {
      {{"format", "cylon-fit/1"}, {"fits", {{{"engine", "ode"}, {"failure", "it lost its worker"}}}}}};
  const std::string page = to_html(report);
  EXPECT_NE(page.find("<th scope=\"row\">ode</th><td>0.570</td><td>the end</td><td>not known</td></tr>"),
            std::string::npos);
  EXPECT_NE(page.find("<th scope=\"row\">bullet</th><td colspan=\"3\">no prediction: &lt;/script"),
            std::string::npos);
  EXPECT_NE(page.find("<th scope=\"row\">ode</th><td colspan=\"3\">no fit: it lost its worker</td>"),
            std::string::npos);
  EXPECT_EQ(page.find("inside the band"), page.find("inside the band", page.find("<script>")));
}

// What no table shows was not mentioned.
TEST(Html, SaysWhatNeedsScripts) {
  HtmlReport report;
  report.documents["histories"] = {{{"schema", 1}, {"series", json::array()}}};
  EXPECT_NE(to_html(report).find("<noscript><p>This file also holds what needs scripts to be shown, and this "
                                 "browser runs none: the history of runs.</p></noscript>"),
            std::string::npos);
  EXPECT_EQ(to_html({}).find("<noscript>"), std::string::npos);
}

TEST(Html, LegendWithoutScriptKeepsItsEntriesApart) {
  HtmlReport report;
  results::Verdict bad = row("top", "ode");
  bad.measured = 100, bad.status = results::Status::fail;
  report.results = RunReport{{}, {row("top", "in-house"), bad}};
  const std::string page = to_html(report);
  const std::size_t end = page.find("differs from expected.toml</p>");
  ASSERT_NE(end, std::string::npos);
  const std::size_t begin = page.rfind("<p>", end);
  EXPECT_EQ(page.substr(begin, end - begin).find('\n'), std::string::npos) << page.substr(begin, end - begin);
  EXPECT_NE(page.find("- is worse; ! differs", begin), std::string::npos) << page.substr(begin, end - begin);
}

TEST(Html, SweepsOfOneScenarioSayWhatMadeThem) {
  HtmlReport report;
  for (const char* words : {"cylon matrix top", "cylon trade top"}) {
    report.documents["trades"].push_back(two_engines());
    report.documents["trades"].back()["provenance"]["command_line"] = words;
  }
  report.documents["trades"][0]["tables"][0]["cells"][0]["refusal"] = "no joints";
  const std::string page = to_html(report);
  EXPECT_NE(page.find("<caption>top of cylon matrix</caption>"), std::string::npos);
  EXPECT_NE(page.find("<caption>top of cylon trade</caption>"), std::string::npos);
  EXPECT_NE(page.find("<td colspan=\"3\">refused: no joints</td></tr>"), std::string::npos);
  report.documents["trades"][1]["provenance"]["command_line"] = "cylon matrix top";
  EXPECT_NE(to_html(report).find("<caption>top of cylon matrix (2)</caption>"), std::string::npos);
  report.documents["trades"].pop_back();
  EXPECT_NE(to_html(report).find("<caption>top</caption>"), std::string::npos);
}

TEST(Html, CountsTracesBeyondSizeLimit) {
  HtmlReport report;
  const std::string large(trace_budget * 2 / 5, 'A');
  for (const char* engine : {"a", "b", "c", "d"}) report.traces.push_back({"top", engine, "", "0.01", large});
  const std::string page = to_html(report);
  const json index = index_of(page);
  EXPECT_EQ(index["traces"].size(), 2u);
  EXPECT_EQ(index["traces"][1]["engine"], "b");
  EXPECT_EQ(index["omitted_traces"], "2 more were left out to limit the size of this file");
  EXPECT_LT(page.size(), 15u << 20);
}

// The name of a fit stood beside each of its parameters: their numbers multiplied.
TEST(Html, PlainTablesOfManyRowsAreCut) {
  HtmlReport report;
  report.documents["fits"] = {
      {{"format", "cylon-fit/1"},
       {"fits",
        {{{"engine", std::string(100'000, 'e')}, {"parameters", std::vector<json>(5000, json::object())}}}}}};
  const std::string page = to_html(report);
  EXPECT_EQ(count(page, "<tr><th scope=\"row\">"), 1000u);
  EXPECT_LT(page.size(), 10u << 20);
  EXPECT_EQ(index_of(page)["fits"][0]["fits"][0]["parameters"].size(), 5000u);
}

}  // namespace
}  // namespace cylon::reports
