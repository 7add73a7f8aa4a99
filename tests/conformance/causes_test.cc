// Every cause of scenarios/expected.toml was tested: its counterfactuals are run and hold, they change the engine that
// has the cause, and one of them follows the law of its size where the law has a power of the step.  Pairs of an optional
// engine that is not here are left out, with a message.
#include "tests/conformance/fixture.h"

#include "harness/scenario/glob.h"
#include "harness/study/cell_pool.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <ostream>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
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

// What a pair of runs shows.  Another engine that passes shows that the scene can be solved, and nothing of why
// the first engine does not.  An error that stays shows what is not the cause; of a law without the step it is the law.
// What is left tests a mechanism: the error changes with the engine, or is found again in another of the same scheme.
enum class Shows { mechanism, unchanged, solvable, not_expressible };

bool of_in_house(const std::string& engine_id) { return engine_id.starts_with("in-house"); }
std::string without_settings(const std::string& engine_id) {
  return engine_id.substr(0, engine_id.find('/'));
}

Shows shows(const Cause& cause, const Counterfactual& c) {
  if (verdict(c.scenario, c.engine, c.dt, c.claim).status == results::Status::unsupported)
    return Shows::not_expressible;
  if (c.becomes)
    return !of_in_house(c.engine) && of_in_house(c.other_engine) ? Shows::solvable : Shows::mechanism;
  const bool same_engine = without_settings(c.engine) == without_settings(c.other_engine);
  return same_engine && c.low <= 1 && 1 <= c.high && cause.power != 0 ? Shows::unchanged : Shows::mechanism;
}

// Their error is as large as the motion at every step that a test can run: no pair shows more than that.
const std::set<std::string> motion_is_lost = {"gyro_keeps_major_axis", "spin_10000_tumbling"};

struct Tested {
  const Cause* cause;
};
void PrintTo(const Tested& tested, std::ostream* out) { *out << tested.cause->name; }

std::vector<Tested> causes() {
  std::vector<Tested> all;
  for (const Cause& cause : expectations().causes()) all.push_back({&cause});
  return all;
}

// Why the pair cannot be run: an engine of it is not here.
std::optional<std::string> missing(const Counterfactual& c) {
  for (const std::string& id : {c.engine, c.other_engine})
    if (const auto reason = process::missing(engine(id).row)) return c.place + ": " + *reason;
  return {};
}

class Causes : public testing::TestWithParam<Tested> {
 protected:
  // The pairs that can be run; tells those that cannot.
  std::vector<Counterfactual> pairs_here() const {
    std::vector<Counterfactual> pairs;
    for (const Counterfactual& c : GetParam().cause->counterfactuals)
      if (const auto reason = missing(c))
        std::cout << *reason << '\n';
      else
        pairs.push_back(c);
    return pairs;
  }
  bool some_missing() const {
    return std::ranges::any_of(GetParam().cause->counterfactuals,
                               [](const Counterfactual& c) { return missing(c).has_value(); });
  }
};

TEST_P(Causes, HoldUnderTheirCounterfactuals) {
  const std::vector<Counterfactual> pairs = pairs_here();
  for (const Counterfactual& c : pairs) {
    const Verdict first = verdict(c.scenario, c.engine, c.dt, c.claim);
    const Verdict other = verdict(c.other_scenario, c.other_engine, c.other_dt, c.other_claim);
    EXPECT_EQ(refutation(c, first, other), "")
        << c.place << ": " << c.claim << " of " << c.scenario << " on " << c.engine << ", then of "
        << c.other_scenario << " on " << c.other_engine << (c.other_dt.empty() ? "" : " at ") << c.other_dt;
    const Cause* why = expectations().explain(c.scenario, c.engine, first.claim);
    EXPECT_EQ(why, GetParam().cause) << c.place << " tests what " << (why ? why->name : "no cause")
                                     << " explains";
  }
  if (some_missing()) GTEST_SKIP() << "pairs of engines that are not here were left out";
}

// That the in-house engine passes was the only test of 17 scenes on one engine or two.
TEST_P(Causes, AreTestedWhereTheyAct) {
  if (some_missing()) GTEST_SKIP() << "needs all pairs, and engines of some are not here";
  const Cause& cause = *GetParam().cause;
  const auto& pairs = cause.counterfactuals;
  const auto is = [&](Shows kind) {
    return [&, kind](const Counterfactual& c) { return shows(cause, c) == kind; };
  };
  EXPECT_TRUE(std::ranges::all_of(pairs, is(Shows::not_expressible)) ||
              std::ranges::any_of(pairs, is(Shows::mechanism)));
  for (const Counterfactual& solvable : pairs) {
    if (shows(cause, solvable) != Shows::solvable) continue;
    const Shows least = motion_is_lost.contains(solvable.scenario) ? Shows::unchanged : Shows::mechanism;
    EXPECT_TRUE(std::ranges::any_of(pairs,
                                    [&](const Counterfactual& c) {
                                      return c.scenario == solvable.scenario && c.engine == solvable.engine &&
                                             shows(cause, c) == least;
                                    }))
        << solvable.place << ": that another engine solves " << solvable.scenario << " is no test of "
        << solvable.engine;
  }
}

// A refusal is no error: another engine, or a scene without what cannot be expressed, must be judged.
TEST_P(Causes, RefuseWhatOthersExpress) {
  const std::vector<Counterfactual> pairs = pairs_here();
  for (const Counterfactual& c : pairs) {
    if (shows(*GetParam().cause, c) != Shows::not_expressible) continue;
    EXPECT_NE(verdict(c.scenario, c.engine, c.dt, c.claim).detail, "")
        << c.place << " is refused without a reason";
    EXPECT_TRUE(c.becomes && results::is_measured(*c.becomes)) << c.place;
  }
  if (some_missing()) GTEST_SKIP() << "pairs of engines that are not here were left out";
}

// Whether the window holds the ratio of the law, is at most half to twice as wide, and holds no ratio of a law
// with one power of the step less or more.
bool tests_power(const Counterfactual& c, double step_ratio, double power) {
  const double ratio = std::pow(step_ratio, power);
  const auto within = [&](double r) { return c.low <= r && r <= c.high; };
  return within(ratio) && c.low >= ratio / 2 && c.high <= 2 * ratio && !within(ratio * step_ratio) &&
         !within(ratio / step_ratio);
}

TEST(CausesOfExpected, WindowsTellPowersApart) {
  Counterfactual c;
  c.low = 0.45, c.high = 0.55;
  EXPECT_TRUE(tests_power(c, 0.5, 1));
  EXPECT_FALSE(tests_power(c, 0.5, 0));
  EXPECT_FALSE(tests_power(c, 0.5, 2));
  c.low = 0.25, c.high = 1;
  EXPECT_FALSE(tests_power(c, 0.5, 1)) << "powers 0 and 2 would do";
  c.high = 0.9;
  EXPECT_FALSE(tests_power(c, 0.5, 1)) << "power 2 would do";
}

TEST_P(Causes, HaveACounterfactualForThePowerOfTheirLaw) {
  const Cause& cause = *GetParam().cause;
  if (!cause.power) return;
  EXPECT_TRUE(std::ranges::any_of(cause.counterfactuals, [&](const Counterfactual& c) {
    if (c.other_dt == c.dt || c.becomes || c.other_engine != c.engine || c.other_scenario != c.scenario)
      return false;
    const scenario::Scenario scenario = shipped(c.scenario);
    return tests_power(c, step_of(scenario, c.other_dt) / step_of(scenario, c.dt), *cause.power);
  })) << cause.law;
}

// The file of a place, where it is here: of this repository all, of an engine the headers that Debian installs.
std::filesystem::path file_of(const std::string& who, const std::string& path) {
  struct Installed {
    std::string_view who, sources, folder;
    bool core;  // part of every build
  };
  static constexpr std::array installed = {
      Installed{"bullet", "src/", "/usr/include/bullet", true},
      Installed{"ode", "include/", "/usr/include", true},
      Installed{"mujoco", "include/", "/usr/include", false},
      Installed{"dart", "dart/", "/usr/include/dart", false},
      Installed{"simbody", "Simbody/include/", "/usr/include/simbody", false},
      Installed{"siconos", "kernel/src/", "/usr/include/siconos/kernel", false}};
  if (who == "in-house") return source(path);
  const auto row = std::ranges::find(installed, who, &Installed::who);
  if (!path.starts_with(row->sources) || (!path.ends_with(".h") && !path.ends_with(".hpp"))) return {};
  const std::filesystem::path file = std::filesystem::path(row->folder) / path.substr(row->sources.size());
  return row->core || std::filesystem::exists(file) ? file : std::filesystem::path();
}

// "who: path:12 word": line 12 holds the word, in every file that is here.
TEST_P(Causes, NameALineOfTheirSource) {
  static const std::regex form(
      R"((bullet|ode|mujoco|dart|simbody|siconos|in-house): ([\w./-]+\.(?:cc|cpp|c|hpp|h|rst)):([1-9]\d*) (\S.*))");
  for (const std::string& place : GetParam().cause->source) {
    std::smatch part;
    ASSERT_TRUE(std::regex_match(place, part, form)) << place;
    const std::filesystem::path path = file_of(part[1], part[2]);
    if (path.empty()) continue;
    const std::string word = part[4];
    std::ifstream file(path);
    ASSERT_TRUE(file) << place << ": " << path << " is not here";
    std::string line;
    for (int number = std::stoi(part[3]); number > 0 && std::getline(file, line);) --number;
    EXPECT_TRUE(file && line.find(word) != std::string::npos) << place << ": the line is '" << line << "'";
  }
}

INSTANTIATE_TEST_SUITE_P(Expected, Causes, testing::ValuesIn(causes()),
                         [](const auto& tested) { return tested.param.cause->name; });

}  // namespace
}  // namespace cylon::conformance
