// The cost of a WebAssembly or JavaScript build is no cost of the native library: each build has a front of its own.
#include "harness/study/sweep.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::study {
namespace {

results::TradeSeries series(const char* engine, const char* version, double error, double cost) {
  results::TradeSeries one;
  one.engine = engine, one.version = version;
  results::TradePoint point;
  point.dt_text = "1/60", point.errors = {error}, point.cost = cost;
  one.points = {point};
  return one;
}

TEST(Fronts, EachBuildHasItsOwn) {
  results::TradeTable table;
  table.measures = {{"position", "m", 1, "truth", 0}};
  table.series = {series("in-house", "0.3.0", 1e-9, 1e-6), series("bullet", "3.24", 1e-2, 1e-5),
                  series("jolt", "1.1.0 (WebAssembly in Node 20.20.2)", 1e-2, 1e-4),
                  series("rapier", "0.21.0 (WebAssembly in Node 20.20.2)", 2e-2, 2e-4),
                  series("cannon-es", "0.20.0 (JavaScript in Node 20.20.2)", 3e-2, 3e-4)};
  mark_front(table);
  const char* dominated_by[] = {"", "in-house at 1/60 s", "", "jolt at 1/60 s", ""};
  for (std::size_t i = 0; i < table.series.size(); ++i) {
    const results::TradePoint& point = table.series[i].points[0];
    EXPECT_EQ(point.dominated_by, dominated_by[i]) << table.series[i].engine;
    EXPECT_EQ(point.on_front, point.dominated_by.empty()) << table.series[i].engine;
  }
}

}  // namespace
}  // namespace cylon::study
