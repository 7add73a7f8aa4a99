// Counting the instructions of an engine's steps: the same count every time, and of the steps alone.
#include "harness/study/instructions.h"

#include "harness/scenario/scenario.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace cylon::study {
namespace {

namespace fs = std::filesystem;

const scenario::Scenario& spring() {
  static const scenario::Scenario scenario =
      scenario::load(std::string(source_dir) + "/scenarios/spring_orbit.toml");
  return scenario;
}

process::EngineChoice engine(const std::string& id) {
  return process::parse_engine(id, process::default_engines(binary_dir));
}

InstructionCount count(const process::EngineChoice& choice, std::int64_t steps = 150,
                       std::int64_t every = 50) {
  return count_instructions(choice, {.scene = &spring().scene, .dt = 0.001, .steps = steps, .every = every});
}

TEST(Instructions, CountersHaveNames) {
  for (const Counter counter : {Counter::off, Counter::perf_event, Counter::callgrind})
    EXPECT_EQ(counter_from(name(counter)), counter);
  EXPECT_EQ(counter_from("callgrin"), std::nullopt);
}

TEST(Instructions, StepsToCountFollowFromTheSceneAlone) {
  const struct {
    std::size_t bodies;
    std::int64_t steps, expected;
  } cases[] = {{1, 10000, 1000}, {1, 300, 150}, {3, 10000, 333}, {1000, 10000, 20}, {1000, 7, 3}, {2, 1, 1}};
  for (const auto& c : cases)
    EXPECT_EQ(steps_to_count(c.bodies, c.steps), c.expected) << c.bodies << ' ' << c.steps;
}

TEST(Instructions, GivesReasonWhenOff) {
  const InstructionCount none = count_instructions(
      engine("in-house"), {.scene = &spring().scene, .dt = 0.001, .steps = 5}, {}, Counter::off);
  EXPECT_FALSE(none.instructions);
  EXPECT_NE(none.remark.find("not counted"), std::string::npos) << none.remark;
}

// Whatever this machine counts with: the same program counts the same, and more work counts more.
TEST(Instructions, CountsRepeatAndScaleWithWork) {
  if (find_counter().counter == Counter::off) {
    EXPECT_NE(find_counter().why.find("valgrind"), std::string::npos);  // and says so
    return;
  }
  const auto rk4 = engine("in-house/integrator=rk4"), euler = engine("in-house/integrator=lie-trotter");
  const InstructionCount first = count(rk4), again = count(rk4), cheap = count(euler),
                         longer = count(rk4, 300);
  ASSERT_TRUE(first.instructions && again.instructions && cheap.instructions && longer.instructions)
      << first.remark << again.remark << cheap.remark << longer.remark;
  EXPECT_GT(*first.instructions, 2 * *cheap.instructions);
  if (find_counter().counter != Counter::callgrind) return;
  EXPECT_TRUE(first.steps_alone) << first.remark;
  EXPECT_EQ(*first.instructions, *again.instructions);
  EXPECT_EQ(*longer.instructions, 2 * *first.instructions);  // rk4 of a spring has no branch on the state
}

// A worker without symbols is counted whole; what is not a step still drops out.
TEST(Instructions, CountsWholeWorkerWithoutSymbols) {
  if (find_counter().counter != Counter::callgrind) return;
  const TemporaryFolder folder;
  const fs::path bare = folder.path() / "cylon-worker-in-house";
  ASSERT_EQ(
      std::system(
          ("strip -o " + bare.string() + " " + std::string(binary_dir) + "/cylon-worker-in-house").c_str()),
      0);
  process::EngineChoice stripped = engine("in-house/integrator=rk4");
  stripped.row.command = {bare.string()};
  const InstructionCount whole = count(stripped), steps = count(engine("in-house/integrator=rk4"), 150, 150);
  ASSERT_TRUE(whole.instructions && steps.instructions) << whole.remark << steps.remark;
  EXPECT_FALSE(whole.steps_alone);
  EXPECT_NE(whole.remark.find("all instructions of the worker"), std::string::npos) << whole.remark;
  const auto measured = static_cast<double>(*whole.instructions),
             exact = static_cast<double>(*steps.instructions);
  EXPECT_NEAR(measured / exact, 1, 0.01);  // what it prints at the end differs by some hundred instructions
}

TEST(Instructions, GivesNoCountIfEngineFails) {
  process::EngineChoice none = engine("in-house");
  none.row.command = {"/bin/false"};
  const InstructionCount count_of_none = count(none);
  EXPECT_FALSE(count_of_none.instructions);
  EXPECT_FALSE(count_of_none.remark.empty());
}

}  // namespace
}  // namespace cylon::study
