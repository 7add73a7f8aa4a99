// Scenes that start from scenarios of somebody's: changes keep them valid.
#include "harness/hunt/source.h"

#include "harness/hunt/dice.h"
#include "harness/hunt/mutate.h"
#include "harness/scenario/scenario.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

namespace cylon::hunt {
namespace {

namespace fs = std::filesystem;

std::vector<Base> shipped() {
  std::vector<Base> bases;
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(source_dir) / "scenarios"))
    if (entry.path().extension() == ".toml" && entry.path().filename() != "expected.toml")
      files.insert(entry.path());
  for (const fs::path& file : files)
    if (Start start = start_from(scenario::read(file)); start.base) bases.push_back(std::move(*start.base));
  return bases;
}

TEST(Source, ChangedScenariosAreAcceptedByTheReader) {
  const std::vector<Base> bases = shipped();
  ASSERT_GT(bases.size(), 80u);
  Dice dice(5, 0);
  for (const Base& base : bases)
    for (int n = 0; n < 6; ++n) {
      const std::string text = to_toml(mutated(dice, base.trial), "");
      ASSERT_NO_THROW(static_cast<void>(scenario::parse(text, "changed.toml"))) << base.name << '\n' << text;
    }
}

TEST(Source, EveryMutationChangesSomeScenario) {
  const std::vector<Base> bases = shipped();
  std::map<std::string_view, int> changed;
  for (const Base& base : bases)
    for (const Mutation& mutation : mutations()) {
      Dice dice(7, 1);
      Trial trial = base.trial;
      if (!mutation.make(dice, trial)) {
        EXPECT_EQ(to_toml(trial, ""), to_toml(base.trial, "")) << base.name << ": " << mutation.says;
        continue;
      }
      changed[mutation.says] += to_toml(trial, "") != to_toml(base.trial, "");
    }
  for (const Mutation& mutation : mutations()) EXPECT_GT(changed[mutation.says], 20) << mutation.says;
}

TEST(Source, IsAFunctionOfSeedNumberAndScenarios) {
  std::vector<Base> bases = shipped();
  const Source source(3, bases);
  std::set<std::string> families, texts;
  for (std::uint64_t n = 0; n < 60; ++n) {
    const Generated one = source.scene(n);
    EXPECT_EQ(to_toml(one.trial, ""), to_toml(Source(3, bases).scene(n).trial, ""));
    families.insert(one.family), texts.insert(to_toml(one.trial, ""));
  }
  EXPECT_GT(families.size(), 20u);
  EXPECT_GT(texts.size(), 55u);  // two changes of one scenario may be alike
  EXPECT_NE(Source(4, bases).name(), source.name());
  bases.pop_back();
  EXPECT_NE(Source(3, bases).name(), source.name());
  EXPECT_EQ(Source(3).name(), "seed 3");
}

TEST(Source, LeavesOutWhatIsTooLarge) {
  scenario::Scenario scenario = scenario::read(fs::path(source_dir) / "scenarios/projectile.toml");
  EXPECT_TRUE(start_from(scenario).base);
  EXPECT_LE(start_from(scenario).base->trial.steps, most_steps);
  scenario.scene.bodies.resize(most_bodies + 1, scenario.scene.bodies[0]);
  EXPECT_FALSE(start_from(scenario).base);
  EXPECT_EQ(start_from(scenario).left_out, "51 bodies, more than 50");
}

}  // namespace
}  // namespace cylon::hunt
