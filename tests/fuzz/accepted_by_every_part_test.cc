// `cylon validate` said ok, and the run then died whole: a mesh index out of range behind a stated inertia, clouds whose
// places overflow.  What the reader accepts, every other part accepts (targets/objection.h): here over the shipped scenes
// and the first random ones; tests/fuzz/accepted.py goes on with as many as one likes.
#include "harness/core/input_error.h"
#include "harness/scenario/scenario.h"
#include "tests/fuzz/targets/objection.h"
#include "tests/fuzz/targets/random_scene.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace cylon::fuzz {
namespace {

// The mean of the nine numbers with their transpose overflowed, or was nothing.
TEST(AcceptedByEveryPart, IsTheLargestAndTheLeastInertia) {
  for (const char* inertia : {"[1, 1e308, 1e308]", "[1e-323, 5e-324, 5e-324]"}) {
    const scenario::Scenario scenario = scenario::parse(
        std::string("duration = 1\nstep = 0.125\n[[body]]\nname = \"b\"\nmass = 1\ninertia = ") +
            std::string(inertia) +
            "\n[[claim]]\n"
            "conserves = \"velocity\"\ntolerance = { absolute = 1, reason = \"none\" }\n",
        "largest.toml");
    EXPECT_EQ(objection(scenario), "") << inertia;
  }
}

TEST(AcceptedByEveryPart, IsEveryShippedScene) {
  const std::vector<SceneFile> all = shipped_scenes(source_dir);
  ASSERT_GT(all.size(), 50u);
  for (const SceneFile& one : all) EXPECT_EQ(objection(scenario::parse(one.text, one.file)), "") << one.file;
}

TEST(AcceptedByEveryPart, IsWhatTheReaderAccepts) {
  constexpr std::uint64_t count = 1500;
  const std::vector<SceneFile> shipped = shipped_scenes(source_dir);
  std::uint64_t accepted = 0;
  for (std::uint64_t n = 0; n < count; ++n) {
    const SceneFile one = random_scene(shipped, n);
    std::optional<scenario::Scenario> scenario;
    try {
      scenario = scenario::parse(one.text, one.file);
    } catch (const core::InputError& error) {
      EXPECT_GT(error.line, 0u) << one.file << ", scene " << n << ": " << error.what();
      continue;
    } catch (const std::exception& error) {
      ADD_FAILURE() << one.file << ", scene " << n << ": " << error.what() << "\n" << one.text;
      continue;
    }
    ++accepted;
    EXPECT_EQ(objection(*scenario), "") << one.file << ", scene " << n << "\n" << one.text;
  }
  EXPECT_GT(accepted, count / 5);
}

// Negative control: a scene whose body is of no size that a worker knows.
TEST(AcceptedByEveryPart, FindsWhatAPartRefuses) {
  const std::vector<SceneFile> shipped = shipped_scenes(source_dir);
  scenario::Scenario scenario = scenario::parse(shipped.front().text, shipped.front().file);
  scenario.scene.bodies.front().mass = -1;
  EXPECT_NE(objection(scenario), "");
}

// As many bodies were enough for a written scene to count as the same.
TEST(AcceptedByEveryPart, FindsAWrittenSceneThatIsAnother) {
  scenario::Scenario scenario = scenario::parse(
      "duration = 1\nstep = 0.125\n[[body]]\nname = \"b\"\nmass = 1\n[[claim]]\nconserves = \"velocity\"\n"
      "tolerance = { absolute = 1, reason = \"none\" }\n",
      "one.toml");
  EXPECT_EQ(objection(scenario), "");
  // A file is read with unit quaternions, so that this one comes back otherwise, by more than rounding.
  scenario.scene.bodies.front().initial.orientation.w() = 1 + 1e-12;
  EXPECT_EQ(objection(scenario), "writer: the written scene has another /body/0/orientation/0");
}

}  // namespace
}  // namespace cylon::fuzz
