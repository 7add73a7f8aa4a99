// Renderings of a table whose every text is hostile: no cell, tag or string may break out.
#include "reports/trade_report.h"
#include "reports/text.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

namespace cylon::reports {
namespace {

using results::TradePoint;
using results::TradeSeries;
using results::TradeTable;

constexpr const char* hostile = "=evil\",<b>&\n\x1b[31m'";

TradePoint point(std::int64_t steps, double error, double cost) {
  TradePoint p;
  p.steps = steps, p.dt = 2.0 / static_cast<double>(steps), p.dt_text = hostile;
  p.errors = {error, 0.5 * error};
  p.step_seconds = 2 * cost, p.load_seconds = 1e-6, p.cost = cost;
  p.on_front = true, p.dominated_by = hostile;
  return p;
}

TradeTable table() {
  TradeTable t;
  t.scenario = hostile, t.duration = 2, t.bodies = 3, t.truth = hostile, t.samples = 17;
  t.measures = {{"trajectory", "m", 1, hostile, 1e-14}, {"energy", "J", 2, "its start", 0}};
  t.target = 1e-3;
  TradeSeries good;
  good.engine = hostile, good.integrator = "rk4", good.precision = "double", good.declared = 4,
  good.order = 3.97;
  good.points = {point(20, 0.02, 1e-5), point(40, 1.3e-3, 2e-5), point(80, 8e-5, 4e-5)};
  TradeSeries bad = good;
  bad.integrator = hostile, bad.order = std::nan("");
  for (TradePoint& p : bad.points) {
    p = TradePoint{.steps = p.steps, .dt = p.dt, .status = results::Status::crash, .reason = hostile};
  }
  t.series = {good, bad};
  return t;
}

TEST(TradeReport, JsonKeepsEveryTextAndTimesStandApart) {
  const auto json = nlohmann::json::parse(
      trade_json({table()}, {}).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
  const auto& series = json["tables"][0]["series"];
  EXPECT_EQ(series[0]["engine"], hostile);
  EXPECT_EQ(series[1]["points"][0]["reason"], hostile);
  EXPECT_TRUE(series[1]["observed_order"].is_null());
  EXPECT_EQ(json["times"].size(), 6u);
  EXPECT_NEAR(json["times"][0]["seconds_per_body_step"].get<double>(), 2e-5 / 60, 1e-15);
  EXPECT_TRUE(json["times"][3]["cpu_seconds_per_second"].is_null());
  EXPECT_EQ(json["tables"].dump().find("seconds"), std::string::npos);  // what differs from run to run
}

TEST(TradeReport, CsvHasAsManyFieldsInEveryRow) {
  const std::string csv = trade_csv({table()});
  std::size_t fields = 1, rows = 0, width = 0;
  bool quoted = false;
  for (const char c : csv) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == ',') ++fields;
    if (c != '\n') continue;
    if (rows++ == 0) width = fields;
    EXPECT_EQ(fields, width) << "row " << rows;
    fields = 1;
  }
  EXPECT_EQ(rows, 7u);
  EXPECT_EQ(csv.find("\n=evil"), std::string::npos);  // a spreadsheet would run it
  EXPECT_EQ(csv.find('\x1b'), std::string::npos);
}

TEST(TradeReport, SvgIsWellFormedAndWithoutScript) {
  const std::string svg = to_svg(trade_plot(table()));
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find('\x1b'), std::string::npos);
  EXPECT_NE(svg.find("=evil&quot;,&lt;b&gt;&amp;"), std::string::npos);
  EXPECT_NE(svg.find("class=\"t\""), std::string::npos);  // the target
  EXPECT_NE(svg.find("class=\"f\""), std::string::npos);  // the front
  EXPECT_NE(svg.find("prefers-color-scheme"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  // Every element that is opened is closed.
  int open = 0;
  for (std::size_t i = 0; i + 1 < svg.size(); ++i) {
    if (svg[i] == '<') open += svg[i + 1] == '/' ? -1 : 1;
    if (svg[i] == '/' && svg[i + 1] == '>') --open;
  }
  EXPECT_EQ(open, 0);
  EXPECT_EQ(svg, to_svg(trade_plot(table())));
}

TEST(TradeReport, EmptyPlotIsValid) {
  const std::string svg = to_svg({});
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(TradeReport, TextSaysOrderFloorCostAndFront) {
  TradeTable t = table();
  t.series[0].floor = 3e-13, t.series[0].floor_from = t.series[0].points[1].dt, t.series[0].rounding = true;
  t.series[0].points[1].dt_text = "1/20";
  const std::string text = trade_text(t, {.width = 100}, true);
  EXPECT_NE(text.find("3.97, floor 3e-13 from 50 ms"), std::string::npos) << text;
  EXPECT_NE(text.find("@1e-03"), std::string::npos);
  EXPECT_NE(text.find("no finite run: crash"), std::string::npos);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  t.truth.clear();
  EXPECT_NE(trade_text(t, {}, false).find("no exact solution is known"), std::string::npos);
  EXPECT_NE(trade_text({}, {}, false).find("nothing to measure"), std::string::npos);
}

// Names of 40 columns were cut at 30, so that rows of one engine looked alike.
TEST(TradeReport, NamesTellRowsApart) {
  TradeTable t = table();
  t.series[1] = t.series[0];
  const std::string common = "engine/path=as-expert,solver=of-a-kind ";
  for (std::size_t k = 0; k < 2; ++k) t.series[k].engine = common.substr(0, common.size() - 1);
  t.series[0].integrator = "merson", t.series[1].integrator = "feldberg";
  const std::string wide = trade_text(t, {.width = 130}, false),
                    narrow = trade_text(t, {.width = 100}, false);
  for (const char* name : {"merson", "feldberg"}) {
    EXPECT_NE(wide.find(common + name), std::string::npos) << wide;
    EXPECT_EQ(narrow.find(common + name), std::string::npos) << "no room beside what was observed";
  }
  for (const std::string& text : {wide, narrow}) {
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line))
      if (line.starts_with("engine/")) {
        EXPECT_LE(display_width(line), text == wide ? 130 : 100) << line;
      }
  }
}

TEST(TradeReport, VariantWithIntegratorIsLabelledNormally) {
  TradeTable t = table();
  t.series[0].engine = "in-house-float/integrator=rk4";
  EXPECT_EQ(trade_label(t, t.series[0]), "in-house-float rk4");
  t.series[0].engine = "bullet/gyro=none";
  EXPECT_EQ(trade_label(t, t.series[0]), "bullet/gyro=none");  // it has one integrator in the table
}

TEST(TradeReport, CheapestMeetsTheTarget) {
  const TradeTable t = table();
  EXPECT_EQ(cheapest(t, t.series[0], 2e-3)->steps, 40);
  EXPECT_EQ(cheapest(t, t.series[0], 1e-9), nullptr);
  EXPECT_EQ(cheapest(t, t.series[1], 1), nullptr);
}

// Two fronts, of which the text and the plot tell which build each is of.
TEST(TradeReport, FrontsOfTwoBuildsStandApart) {
  TradeTable both = table();
  both.series[1] = both.series[0];
  both.series[1].version = "1.1.0 (WebAssembly in Node 20.20.2)";
  const std::string text = trade_text(both, {}, false);
  EXPECT_NE(text.find("\nPareto front (*): no other"), std::string::npos) << text;
  EXPECT_NE(text.find("\nPareto front (*) of WebAssembly in Node 20.20.2: none of these"), std::string::npos)
      << text;
  EXPECT_EQ(trade_plot(both).fronts.size(), 2u);
  EXPECT_EQ(trade_plot(table()).fronts.size(), 1u);
}

}  // namespace
}  // namespace cylon::reports
