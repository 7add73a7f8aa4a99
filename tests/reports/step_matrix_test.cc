// Which step of a sweep counts, what is said where none does, and how the matrix shows it.
#include "reports/step_matrix.h"
#include "reports/trade_report.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace cylon::reports {
namespace {

using results::TradePoint;
using results::TradeSeries;
using results::TradeTable;

const ConsoleOptions plain{.width = 100, .utf8 = true, .colour = false};

// Steps of 0.032 s, 0.016 s, …, a cost that doubles; NaN: the run did not end.
TradeSeries stepped(const std::string& engine, const std::vector<double>& errors, double order) {
  TradeSeries series;
  series.engine = engine, series.integrator = "semi-implicit-euler", series.precision = "double";
  series.declared = 1, series.order = order;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    TradePoint p;
    p.dt = std::ldexp(0.032, -static_cast<int>(i)), p.steps = 25 << i, p.cost = 3e-6 * std::exp2(i);
    if (std::isnan(errors[i]))
      p.status = results::Status::crash, p.reason = "signal 11";
    else
      p.errors = {errors[i], 0.5};
    series.points.push_back(p);
  }
  return series;
}

TradeTable table_of(std::vector<TradeSeries> series) {
  TradeTable t;
  t.scenario = "throw", t.duration = 0.8, t.bodies = 2;
  t.measures = {{"trajectory", "m", 1, "projectile", 1e-14}, {"energy", "J", 2, "its start", 0}};
  t.series = std::move(series);
  return t;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A cost in WebAssembly is not to be taken for that of the native library.
TEST(StepMatrix, SaysWhatBuildItsCostsAreOf) {
  TradeTable t = table_of({stepped("jolt/slop=0", {0.006, 0.003}, 1), stepped("bullet", {0.006, 0.003}, 1)});
  t.series[0].version = "1.1.0 (WebAssembly in Node 20.20.2)", t.series[1].version = "3.24";
  const std::string note = "\njolt: costs of WebAssembly in Node 20.20.2, not of native code.\n";
  for (const std::string& text : {steps_text({t}, plain), trade_text(t, plain, false)}) {
    EXPECT_TRUE(contains(text, note)) << text;
    EXPECT_FALSE(contains(text, "bullet: costs")) << text;
  }
}

// Errors at a step of four parts are those of a step of a quarter.
TEST(StepMatrix, SaysHowManySubstepsAStepHas) {
  TradeTable t = table_of({stepped("rapier", {0.006, 0.003}, 1), stepped("bullet", {0.006, 0.003}, 1)});
  t.series[0].substeps = 4;
  const std::string note = "\nrapier: 4 substeps in each step.\n";
  for (const std::string& text :
       {steps_text({t}, plain), digits_text({t}, 0.02, plain), trade_text(t, plain, false)}) {
    EXPECT_TRUE(contains(text, note)) << text;
    EXPECT_FALSE(contains(text, "bullet: ")) << text;
  }
  const auto series = trade_json({t}, {}).at("tables")[0].at("series");
  EXPECT_EQ(series[0].at("substeps"), 4);
  EXPECT_EQ(series[1].at("substeps"), 1);
  EXPECT_TRUE(contains(trade_csv({t}), ",dt_text,substeps,tolerance,"));
}

TEST(StepMatrix, TheCoarsestStepThatServesAndTheNextFinerOneToo) {
  const double nan = std::nan("");
  const struct {
    const char* what;
    std::vector<double> errors;
    int at;  // -1: nowhere
  } rows[] = {{"falls", {0.03, 0.014, 0.006, 0.0031}, 2},
              {"the coarsest tried", {0.006, 0.003, 0.0014}, 0},
              {"a lucky step", {0.03, 0.004, 0.017, 0.008, 0.0039}, 3},
              {"the finest alone", {0.03, 0.014, 0.0061}, 2},
              {"never", {0.3, 0.17, 0.08}, -1},
              {"a crash between", {0.006, nan, 0.0061, 0.0029}, 2},
              {"rises again", {0.006, 0.03, 0.2}, -1},
              {"exactly", {0.02, 0.01, 0.005}, 1}};
  for (const auto& row : rows) {
    const TradeTable table = table_of({stepped("bullet", row.errors, 1)});
    const auto point = coarsest_point(table, table.series[0], 1e-2);
    EXPECT_EQ(point ? static_cast<int>(*point) : -1, row.at) << row.what;
  }
}

TEST(StepMatrix, NamesTheCauseWhereNoStepServes) {
  TradeSeries known = stepped("ode", {0.06, 0.03, 0.015, 0.0071}, 1);
  known.cause = "gyroscopic_term";
  const std::string text = steps_text({table_of({known})}, plain);
  EXPECT_TRUE(contains(text, "; cause: gyroscopic_term")) << text;
  const auto cells = results::step_cells(table_of({known}));
  EXPECT_FALSE(contains(cells[0].reach[0].why, "cause")) << "reached";
  TradeSeries once = stepped("ode", {0.06}, std::nan(""));
  once.cause = "gyroscopic_term";
  EXPECT_FALSE(contains(results::step_cells(table_of({once}))[0].reach[0].why, "cause")) << "one step";
}

TEST(StepMatrix, SaysWhyNoStepServes) {
  const double nan = std::nan("");
  TradeSeries floor = stepped("bullet-float", {0.01, 0.0021, 0.0004, 0.0004}, 2);
  floor.floor = 4e-4, floor.floor_from = 0.008, floor.rounding = true, floor.precision = "float";
  TradeSeries stalls = floor;
  stalls.rounding = false;
  TradeSeries refused = stepped("ode", {}, nan);
  refused.reason = "no water";
  TradeSeries adaptive = stepped("auto", {0.01, 0.003}, nan);
  adaptive.adaptive = true, adaptive.points[1].tolerance = 1e-3;
  TradeSeries slow = stepped("bullet", {0.08, nan}, 1);
  slow.points[1].status = results::Status::timeout;
  const struct {
    TradeSeries series;
    const char* why;
  } rows[] = {// 0.004 s at 0.0037 of first order: 1e-4 at 0.004/37
              {stepped("bullet", {0.03, 0.015, 0.0074, 0.0037}, 1), "needs about 0.11 ms at this order"},
              // of order 2 at the same place: 0.004/sqrt 37
              {stepped("bullet", {0.24, 0.06, 0.015, 0.0037}, 2), "needs about 0.66 ms at this order"},
              {stepped("bullet", {1.4, 1.2, 0.9}, 0.2), "never near: error 0.9 at 8 ms"},
              {stepped("bullet", {0.04, 0.05, 0.03}, nan), "error 0.03 at 8 ms, falls with no order"},
              {stepped("bullet", {0.04}, nan), "error 0.04 at 32 ms, too few steps tried for an order"},
              {stepped("bullet", {nan, nan}, nan), "no run ends: crash, signal 11"},
              {stepped("bullet", {0.03, 0.00004, 0.02}, 1), "met at single steps only: the error scatters"},
              {floor, "stays at 0.0004 below 8 ms: rounding in single precision"},
              {stalls, "stays at 0.0004 below 8 ms"},
              {refused, "no water"},
              {adaptive, "error 0.003 at tolerance 1e-03"},
              {slow, "error 0.08 at 32 ms, time limit exceeded below"}};
  for (const auto& row : rows) {
    const TradeTable table = table_of({row.series});
    EXPECT_EQ(why_not_reached(table, table.series[0], 1e-4), row.why);
  }
}

TEST(StepMatrix, ARefusalIsAvoidableWhereAnotherEngineReachesAnError) {
  TradeSeries refused = stepped("ode", {}, std::nan(""));
  refused.reason = "no water";
  const auto with = [&](const std::vector<double>& errors) {
    return results::step_cells(table_of({refused, stepped("bullet", errors, 1)}));
  };
  EXPECT_EQ(with({0.03, 0.009, 0.004})[0].avoidable, "bullet");
  EXPECT_EQ(with({0.9, 0.8, 0.7})[0].avoidable, "");
  EXPECT_EQ(with({0.03, 0.009, 0.004})[0].refusal, "no water");
  EXPECT_EQ(with({0.03, 0.009, 0.004})[1].refusal, "");
}

// A tolerance says nothing of an engine that goes by fixed steps: its first integrator of those counts.
TEST(StepMatrix, AnEngineThatStepsInAnyCaseIsShownByItsSteps) {
  TradeSeries own = stepped("in-house", {0.004, 0.004}, std::nan(""));
  own.adaptive = true, own.path = "stepping";
  TradeTable table = table_of({own, stepped("in-house", {0.03, 0.008}, 1)});
  ASSERT_EQ(results::step_cells(table).size(), 1u);
  EXPECT_EQ(results::step_cells(table)[0].series, 1u);
  table.series[0].path = "events";
  EXPECT_EQ(results::step_cells(table)[0].series, 0u);
}

TEST(StepMatrix, TextSaysStepCostOrderAndReason) {
  TradeSeries closed = stepped("in-house", {1e-15, 1e-15, 1e-15}, std::nan(""));
  closed.adaptive = closed.closed_form = true;
  for (TradePoint& p : closed.points) p.tolerance = 1e-2;
  const std::string text =
      steps_text({table_of({stepped("bullet", {0.03, 0.014, 0.006, 0.0031}, 1.04), closed})}, plain);
  for (const char* part : {"throw: 0.8 s, 2 bodies; error of trajectory against projectile",
                           "8 ms      12 µs", "1.04   1e-3: needs about", "not reached", "no steps  3 µs",
                           "no steps: the engine has the motion in closed form"})
    EXPECT_TRUE(contains(text, part)) << part << '\n' << text;
  EXPECT_FALSE(contains(text, "tol:")) << text;
}

TEST(StepMatrix, DigitsAreOfTheCoarsestTriedStepThatIsNotCoarser) {
  TradeSeries closed = stepped("in-house", {1e-15}, std::nan(""));
  closed.closed_form = true;
  const TradeTable table = table_of({stepped("bullet", {0.03, 0.01, 0.001}, 1), closed});
  const auto at = results::digits_at(table, table.series[0], 0.017);
  ASSERT_TRUE(at);
  EXPECT_EQ(at->point, 1u);
  EXPECT_NEAR(at->digits, 2, 1e-12);
  EXPECT_FALSE(results::digits_at(table, table.series[0], 1e-3));
  const std::string text = digits_text({table}, 0.01, plain);
  EXPECT_TRUE(contains(text, "throw     8 ms       3.0          closed form")) << text;
}

TEST(StepMatrix, JsonHasACellPerEngine) {
  const auto json = steps_json(table_of({stepped("bullet", {0.03, 0.014, 0.006, 0.0031}, 1)}));
  ASSERT_EQ(json.size(), 1u);
  EXPECT_EQ(json[0]["reach"][0]["point"], 2);
  EXPECT_TRUE(json[0]["reach"][1]["point"].is_null());
  EXPECT_TRUE(steps_json(TradeTable{.scenario = "nothing to measure"}).empty());
}

}  // namespace
}  // namespace cylon::reports
