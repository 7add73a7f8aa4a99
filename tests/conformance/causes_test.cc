// Every cause of scenarios/expected.toml was tested: its counterfactuals are run and hold, and one of them
// follows the law of its size where the law has a power of the step.
#include "tests/conformance/fixture.h"

#include "harness/scenario/glob.h"
#include "harness/study/cell_pool.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <ostream>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace cylon::conformance {
namespace {

using results::Verdict;
using scenario::Cause;
using scenario::Counterfactual;

const scenario::Expectations& expectations() {
  static const auto loaded = scenario::Expectations::load(source("scenarios/expected.toml"));
  return loaded;
}

double step_of(const scenario::Scenario& scenario, const std::string& dt) {
  return dt.empty() ? scenario.step : scenario::parse_step(dt);
}

// What is run for counterfactuals: one motion, and the claims that they are about.
struct Run {
  std::set<std::string> globs;
  std::vector<Verdict> rows;
};
using Key = std::tuple<std::string, std::string, std::string, bool>;  // scenario, engine, step, relations

bool of_relations(const std::string& claim) { return claim.starts_with("relation "); }

std::map<Key, Run> planned_runs() {
  std::map<Key, Run> runs;
  for (const Cause& cause : expectations().causes())
    for (const Counterfactual& c : cause.counterfactuals) {
      runs[{c.scenario, c.engine, c.dt, of_relations(c.claim)}].globs.insert(c.claim);
      runs[{c.other_scenario, c.other_engine, c.other_dt, of_relations(c.other_claim)}].globs.insert(
          c.other_claim);
    }
  return runs;
}

// The verdict on the one claim that the glob matches; a run is made once, for all that is asked of it.
Verdict verdict(const std::string& name, const std::string& engine_id, const std::string& dt,
                const std::string& claim) {
  static std::map<Key, Run> runs = planned_runs();
  const bool relation = of_relations(claim);
  Run& run = runs[{name, engine_id, dt, relation}];
  std::vector<Verdict>& rows = run.rows;
  if (rows.empty()) {
    scenario::Scenario scenario = shipped(name);
    if (!relation)
      std::erase_if(scenario.claims, [&](const core::Claim& one) {
        return std::ranges::none_of(
            run.globs, [&](const std::string& glob) { return scenario::glob_match(glob, one.label); });
      });
    study::Cell cell{&scenario, engine(engine_id), step_of(scenario, dt),
                     dt.empty() ? scenario.step_text : dt};
    if (relation) cell.exam = study::Exam::relations;
    const study::Matrix matrix = study::run({cell}, {.workers = 1, .limits = {}}, {}, {});
    for (const auto& complaints : {matrix.refused, matrix.failed})
      if (!complaints.empty()) throw std::invalid_argument(complaints.front());
    rows = matrix.rows.at(0);
  }
  std::vector<Verdict> found;
  for (const Verdict& row : rows)
    if (scenario::glob_match(claim, row.claim)) found.push_back(row);
  if (found.size() != 1)
    throw std::invalid_argument(fmt::format("'{}' matches {} claims of {}", claim, found.size(), name));
  return found[0];
}

struct Tested {
  const Cause* cause;
};
void PrintTo(const Tested& tested, std::ostream* out) { *out << tested.cause->name; }

std::vector<Tested> causes() {
  std::vector<Tested> all;
  for (const Cause& cause : expectations().causes()) all.push_back({&cause});
  return all;
}

class Causes : public testing::TestWithParam<Tested> {};

TEST_P(Causes, HoldUnderTheirCounterfactuals) {
  for (const Counterfactual& c : GetParam().cause->counterfactuals) {
    const Verdict first = verdict(c.scenario, c.engine, c.dt, c.claim);
    const Verdict other = verdict(c.other_scenario, c.other_engine, c.other_dt, c.other_claim);
    EXPECT_EQ(refutation(c, first, other), "")
        << c.place << ": " << c.claim << " of " << c.scenario << " on " << c.engine << ", then of "
        << c.other_scenario << " on " << c.other_engine << (c.other_dt.empty() ? "" : " at ") << c.other_dt;
    const Cause* why = expectations().explain(c.scenario, c.engine, first.claim);
    EXPECT_EQ(why, GetParam().cause) << c.place << " tests what " << (why ? why->name : "no cause")
                                     << " explains";
  }
}

TEST_P(Causes, HaveACounterfactualForThePowerOfTheirLaw) {
  const Cause& cause = *GetParam().cause;
  if (!cause.power) return;
  EXPECT_TRUE(std::ranges::any_of(cause.counterfactuals, [&](const Counterfactual& c) {
    if (c.other_dt == c.dt || c.becomes || c.other_engine != c.engine || c.other_scenario != c.scenario)
      return false;
    const scenario::Scenario scenario = shipped(c.scenario);
    const double ratio = std::pow(step_of(scenario, c.other_dt) / step_of(scenario, c.dt), *cause.power);
    return c.low <= ratio && ratio <= c.high && c.low >= ratio / 2 && c.high <= 2 * ratio;
  })) << cause.law;
}

// "who: path:12 word".  Of Bullet and ODE the sources are not here; of this repository line 12 holds the word.
TEST_P(Causes, NameALineOfTheirSource) {
  static const std::regex form(R"((bullet|ode|in-house): ([\w./-]+\.(?:cc|cpp|h)):([1-9]\d*) (\S.*))");
  for (const std::string& place : GetParam().cause->source) {
    std::smatch part;
    ASSERT_TRUE(std::regex_match(place, part, form)) << place;
    if (part[1] != "in-house") continue;
    const std::string word = part[4];
    std::ifstream file(source(part[2]));
    std::string line;
    for (int number = std::stoi(part[3]); number > 0 && std::getline(file, line);) --number;
    EXPECT_TRUE(file && line.find(word) != std::string::npos) << place << ": the line is '" << line << "'";
  }
}

INSTANTIATE_TEST_SUITE_P(Expected, Causes, testing::ValuesIn(causes()),
                         [](const auto& tested) { return tested.param.cause->name; });

}  // namespace
}  // namespace cylon::conformance
