// Whose costs an advice shows, for people and programs.
#include "reports/advice_report.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <utility>

namespace cylon::reports {
namespace {

const ConsoleOptions plain{.width = 100, .utf8 = true, .colour = false};

results::EngineAdvice advised(const std::string& engine, const std::string& version) {
  results::EngineAdvice one;
  one.engine = engine, one.version = version;
  one.pick = results::Pick{.engine = engine,
                           .integrator = "semi-implicit-euler",
                           .at = "1/500 s",
                           .steps = 700,
                           .dt = 0.002,
                           .error = 0.0043,
                           .cost = 3.1e-4};
  one.best = one.pick;
  return one;
}

results::Advice advice() {
  results::Advice all;
  all.scenario = "spring_orbit", all.measure = "trajectory", all.against = "spring_orbit";
  all.duration = 1.4, all.tolerance = 0.01;
  all.engines = {advised("ode", "0.16.5"), advised("jolt", "1.1.0 (WebAssembly in Node 20.20.2)"),
                 advised("crashcat", "0.0.3 (JavaScript in Node 20.20.2)")};
  return all;
}

// A cost in WebAssembly is not to be taken for that of the native library.
TEST(AdviceReport, TextSaysWhatBuildItsCostsAreOf) {
  const std::string text = advice_text(advice(), plain);
  EXPECT_NE(text.find("\ncrashcat: costs of JavaScript in Node 20.20.2, not of native code.\n"
                      "jolt: costs of WebAssembly in Node 20.20.2, not of native code.\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("ode: costs"), std::string::npos) << text;
}

TEST(AdviceReport, AMarginHasTwoDigits) {
  const std::pair<double, const char*> rows[] = {
      {0.0043, ", 2.3 times below"}, {0.00043, ", 23 times below"}, {5.95e-15, ", 1.7e+12 times below"}};
  for (const auto& [error, says] : rows) {
    results::Advice all = advice();
    all.engines[0].pick->error = error;
    const std::string text = advice_text(all, plain);
    EXPECT_NE(text.find(says), std::string::npos) << text;
  }
}

TEST(AdviceReport, AStepIsNamedWithItsSubsteps) {
  results::Advice all = advice();
  all.engines[1].pick->substeps = 4;
  const std::string text = advice_text(all, plain);
  EXPECT_NE(text.find("jolt semi-implicit-euler at 1/500 s (4 substeps)\n"), std::string::npos) << text;
  EXPECT_NE(text.find("ode semi-implicit-euler at 1/500 s\n"), std::string::npos) << text;
  const auto engines = nlohmann::json::parse(advice_json(all, {})).at("engines");
  EXPECT_EQ(engines[0].at("pick").at("substeps"), 1);
  EXPECT_EQ(engines[1].at("pick").at("substeps"), 4);
}

TEST(AdviceReport, JsonHasVersionAndBuildOfEachEngine) {
  const auto engines = nlohmann::json::parse(advice_json(advice(), {})).at("engines");
  const struct {
    const char *version, *build;
  } rows[] = {{"0.16.5", ""},
              {"1.1.0 (WebAssembly in Node 20.20.2)", "WebAssembly in Node 20.20.2"},
              {"0.0.3 (JavaScript in Node 20.20.2)", "JavaScript in Node 20.20.2"}};
  for (std::size_t i = 0; i < std::size(rows); ++i) {
    EXPECT_EQ(engines[i].at("version"), rows[i].version);
    EXPECT_EQ(engines[i].at("build"), rows[i].build);
  }
}

}  // namespace
}  // namespace cylon::reports
