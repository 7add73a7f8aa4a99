// Nobody passes by doing nothing: in every shipped scene that moves, a claim as it stands in the file accuses
// an engine that stands still, one that does so after the first step, whether it says so or goes on to tell the speeds of
// that step, one that lets everything fall freely where that is wrong, and one that answers with the step before.
#include "tests/mutants/matrix/shipped.h"
#include "tests/mutants/matrix/told.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <ostream>
#include <set>

namespace cylon::mutants {
namespace {

// Scenes of static_scenes.txt, and those of them that move but have a reason to be there, as "name<tab>reason".
struct Listed {
  std::set<std::string> at_rest, undecided;
};

Listed listed() {
  std::ifstream file(std::filesystem::path(source_dir) / "tests/mutants/static_scenes.txt");
  Listed all;
  for (std::string line; std::getline(file, line);)
    if (!line.empty() && line.front() != '#')
      (line.find('\t') == std::string::npos ? all.at_rest : all.undecided).insert(line);
  return all;
}

std::set<std::string> undecided_lines() {
  std::set<std::string> lines;
  for (const Undecided& row : undecided()) lines.insert(std::string(row.scenario) + '\t' + row.reason);
  return lines;
}

bool is_undecided(const std::string& name) {
  return std::ranges::find(undecided(), name, &Undecided::scenario) != undecided().end();
}

Subject mutant(const char* name) {
  for (const Subject& subject : decorated_mutants())
    if (subject.name == name) return subject;
  throw std::logic_error(name);
}

std::string told(const ShippedRun& run) {
  std::string text;
  for (const ShippedFinding& f : run.findings)
    text += "\n  " + f.claim + ": " + std::to_string(f.measured) + " of " + std::to_string(f.allowed);
  return text;
}

// One that answers with the step before: of the in-house engine, or, where it refuses the scene, of the
// truth.
std::optional<ShippedRun> late(ShippedFile& file) {
  if (const auto& run = file.run(mutant("one step late"))) return run;
  for (const core::Claim& claim : file.scenario().claims)
    if (claim.truth && claim.truth->times.empty())
      return run_shipped(file.scenario(), one_step_late(claim.truth->state));
  return std::nullopt;
}

std::string name_of(const testing::TestParamInfo<std::filesystem::path>& info) {
  std::string name = info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

class Shipped : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Shipped, AccusesWhoeverDoesNothing) {
  ShippedFile& file = ShippedFile::of(GetParam());
  const scenario::Scenario& scenario = file.scenario();
  const auto& right = file.run(correct_subjects().front());
  const bool moving = dynamic(scenario, right);
  EXPECT_EQ(!moving && !is_undecided(scenario.name), listed().at_rest.contains(scenario.name))
      << "tests/mutants/static_scenes.txt is not current: mutants --static writes it";
  if (right && is_undecided(scenario.name)) {
    EXPECT_TRUE(moves(scenario.scene, right->recording.states)) << "at rest, and so no exception";
  }
  if (right) {
    EXPECT_TRUE(right->passes()) << "the in-house engine" << told(*right);
  }
  if (!moving) return;

  const auto still = run_shipped(scenario, frozen());
  EXPECT_TRUE(still->accused()) << "an engine that stands still passes" << told(*still);

  if (right) {
    core::State first = right->recording.states.at(1);
    for (const bool says_so : {false, true}) {
      for (core::BodyState& s : first)
        if (says_so) s.velocity.setZero(), s.angular_velocity.setZero();
      const auto ended = run_shipped(scenario, stopped(first));
      if (moves_apart(scenario.scene, right->recording.states, ended->recording.states)) {
        EXPECT_TRUE(ended->accused())
            << "an engine that stands still after the first step passes, says so: " << says_so
            << told(*ended);
      }
    }
  }

  const auto falling = run_shipped(scenario, mutant("only falls"));
  const bool wrong =
      falling && (!right || moves_apart(scenario.scene, right->recording.states, falling->recording.states));
  if (wrong) {
    EXPECT_TRUE(falling->accused()) << "an engine of free fall alone passes" << told(*falling);
  }

  if (const auto delayed = late(file)) {
    EXPECT_TRUE(delayed->accused()) << "an engine that is a step late passes" << told(*delayed);
  }
}
INSTANTIATE_TEST_SUITE_P(All, Shipped, testing::ValuesIn(shipped_scenarios()), name_of);

TEST(StaticScenes, AreShipped) {
  std::set<std::string> names;
  for (const auto& file : shipped_scenarios()) names.insert(file.stem().string());
  for (const std::string& name : listed().at_rest) EXPECT_TRUE(names.contains(name)) << name;
  EXPECT_EQ(listed().undecided, undecided_lines());
  for (const Undecided& row : undecided()) EXPECT_TRUE(names.contains(row.scenario)) << row.scenario;
}

}  // namespace
}  // namespace cylon::mutants
