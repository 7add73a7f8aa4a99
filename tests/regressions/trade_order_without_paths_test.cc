// `cylon trade` took a worker that names no path for one that had not loaded the scene: its series declared
// order 0 and lost its integrator.  Now order 0 says that the scene was never loaded, whatever the worker
// names.
#include "harness/study/sweep.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

namespace cylon::study {
namespace {

results::TradeSeries series_of(const std::string& scenario_name) {
  const scenario::Scenario scenario =
      scenario::load(std::string(source_dir) + "/scenarios/" + scenario_name + ".toml");
  const std::string script = std::string(source_dir) + "/docs/examples/foreign_engine.py";
  const process::EngineChoice engine = {"mine", {"mine", {"python3", script}, ""}, "", "", {}};
  std::vector<Setting> settings = {{engine, {}, true, true}};
  Memory nothing;
  const Yardstick yardstick(scenario, 20);
  return sweep_errors(scenario, yardstick, {20, {400}}, settings, {}, nothing, {}).series.at(0);
}

TEST(TradeOrder, IsThatOfWorkerWithoutPaths) {
  const results::TradeSeries series = series_of("projectile");
  EXPECT_EQ(results::name(series.points.at(0).status), "pass") << series.points[0].reason;
  EXPECT_EQ(series.integrator, "verlet");
  EXPECT_EQ(series.declared, 2);
}

TEST(TradeOrder, IsZeroWhereSceneWasNotLoaded) {
  const results::TradeSeries series = series_of("block_slides");
  EXPECT_EQ(series.reason, "no contacts, but 'block' collides");
  EXPECT_EQ(series.declared, 0);
}

}  // namespace
}  // namespace cylon::study
