// The suite of measured motions on real engines: verdicts as expected, and wrong models told from right ones.
#include "tests/conformance/fixture.h"

#include "reference/measured/claim_truth.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace cylon::conformance {
namespace {

using results::Status, results::Verdict;

const std::string folder = "scenarios/validation/";

class Validation : public testing::Test {
 protected:
  void SetUp() override { measured::serve_scenarios(); }

  static scenario::Suite suite() { return scenario::load_suite(source("scenarios/suites/validation.toml")); }

  // The scenario with a text in the place of another: whatever is uncertain starts from there.
  static scenario::Scenario changed(const std::string& name, const std::string& what = "",
                                    const std::string& instead = "") {
    std::string text = scenario::read_file(source(folder + name + ".toml"));
    const std::size_t at = text.find(what);
    if (at == std::string::npos) throw std::invalid_argument(what);
    return scenario::parse(text.replace(at, what.size(), instead), source(folder + name + ".toml").string());
  }

  static std::vector<Verdict> verdicts(const scenario::Scenario& s, const std::string& id, double scale = 1) {
    study::Cell cell{&s, engine(id), s.step, s.step_text};
    cell.tolerance_scale = scale;
    return study::run(cell, process::Limits{},
                      scenario::Expectations::load(source("scenarios/expected.toml")));
  }

  static std::string said(const Verdict& v) {
    const results::Bounds known = v.interval.value_or(results::Bounds{});
    return fmt::format("{} of {} on {}: {}, {:.6g} in [{:.6g}, {:.6g}], allowed {:.6g}; {}", v.claim,
                       v.scenario, v.engine, results::name(v.status), v.measured, known.low, known.high,
                       v.allowed, v.detail);
  }
};

TEST_F(Validation, EveryFileOfTheFolderIsInTheSuiteAndValidates) {
  const auto listed = suite().scenarios;
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(source(folder)))
    if (entry.path().extension() == ".toml") files.insert(entry.path().stem().string());
  EXPECT_EQ(std::set<std::string>(listed.begin(), listed.end()), files);
  for (const std::string& name : files) {
    const scenario::Scenario s = changed(name);
    EXPECT_NE(std::ranges::find(s.tags, "measured"), s.tags.end()) << name;
    EXPECT_TRUE(std::ranges::any_of(s.claims, core::validates)) << name;
  }
}

TEST_F(Validation, EveryVerdictIsAsExpected) {
  for (const std::string& name : suite().scenarios)
    for (const std::string& id : suite().engines)
      for (const Verdict& v : verdicts(changed(name), id)) {
        EXPECT_TRUE(v.as_expected()) << said(v);
        EXPECT_EQ(v.interval.has_value(), v.evidence == "validated") << said(v);
        if (!v.interval) continue;
        EXPECT_LE(v.interval->low, v.measured) << said(v);
        EXPECT_GE(v.interval->high, v.measured) << said(v);
      }
}

// Gravity that is a tenth off, and an arm without its loss, are told; a tolerance within the noise decides nothing.
TEST_F(Validation, WrongModelsFailAndNoiseDecidesNothing) {
  const auto of = [&](const scenario::Scenario& s, double scale = 1) {
    return verdicts(s, "in-house", scale).at(0);
  };
  const Verdict right = of(changed("measured_pendulum"));
  EXPECT_EQ(right.status, Status::pass) << said(right);
  const Verdict light = of(changed("measured_pendulum", "-9.8083", "-8.8275"));
  EXPECT_EQ(light.status, Status::fail) << said(light);
  const Verdict tight = of(changed("measured_pendulum"), right.measured / right.allowed);
  EXPECT_EQ(tight.status, Status::undecided) << said(tight);
}

}  // namespace
}  // namespace cylon::conformance
