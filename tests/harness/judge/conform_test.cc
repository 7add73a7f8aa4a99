// The judge as one call: who conforms, who does not, and what the message says.
#include "harness/judge/conform.h"
#include "cylon/gtest.h"
#include "tests/paths.h"

#include "harness/core/input_error.h"

#include <gtest/gtest.h>
#include <immintrin.h>

#include <cfenv>
#include <filesystem>
#include <limits>
#include <string>

namespace cylon::judge {
namespace {

const std::filesystem::path folder = std::filesystem::path(source_dir) / "scenarios";

std::string worker(const std::string& build) { return std::string(binary_dir) + "/cylon-worker-" + build; }

const Engine example{
    std::vector<std::string>{"python3", std::string(source_dir) + "/docs/examples/foreign_engine.py"}};

TEST(Conforms, WhoMeetsEveryClaim) {
  EXPECT_CONFORMS(worker("in-house"), "heavy_top");
  EXPECT_CONFORMS(example, "projectile");
  EXPECT_CONFORMS(worker("in-house"), "projectile", Asked{.dt = 1.0 / 500});
}

struct Case {
  const char* what;
  Engine engine;
  const char* scenario;
  Asked asked;
  const char* says;
};

const Case cases[] = {
    {"an error beyond the tolerance",
     worker("ode"),
     "heavy_top",
     {},
     "position follows heavy_top: fail: measured "},
    {"an error a little beyond it",
     worker("ode"),
     "projectile",
     {},
     "position follows projectile: low-quality: measured "},
    {"a variant that is worse",
     Engine({worker("in-house")}, "integrator=explicit-euler"),
     "heavy_top",
     {},
     "explicit-euler"},
    {"a scene that is refused", example, "heavy_top", {}, "unsupported: no joint"},
    {"no tolerance at all", worker("in-house"), "projectile", {.tolerance_scale = 0}, "allowed 0 m"},
    {"a worker that is not there", "./nobody", "projectile", {}, "cannot start './nobody'"},
    {"a worker that says nothing", "true", "projectile", {}, "crash: exited 0 before done"},
    {"an unknown scenario", worker("in-house"), "heavy_topp", {}, "no scenario 'heavy_topp' in "},
    {"its nearest name", worker("in-house"), "heavy_topp", {}, "did you mean 'heavy_top'?"},
    {"a step that does not fit", worker("in-house"), "projectile", {.dt = 0.3}, "the duration"},
    {"an unknown variant", Engine({worker("in-house")}, "integrator=rk5"), "projectile", {}, "rk5"},
};

TEST(Conforms, NotWhoFailsAndTheMessageSaysWhere) {
  for (const Case& c : cases) {
    const testing::AssertionResult found = conforms(c.engine, c.scenario, c.asked);
    EXPECT_FALSE(found) << c.what;
    EXPECT_NE(std::string(found.message()).find(c.says), std::string::npos) << c.what << ":\n"
                                                                            << found.message();
  }
}

TEST(Conforms, RefusesImpossibleRequests) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(conform(example, "projectile", folder, {.dt = -1}), core::InputError);
  EXPECT_THROW(conform(example, "projectile", folder, {.dt = nan}), core::InputError);
  EXPECT_THROW(conform(example, "projectile", folder, {.tolerance_scale = nan}), core::InputError);
  EXPECT_THROW(conform(Engine(std::vector<std::string>{}), "projectile", folder), core::InputError);
}

TEST(Conforms, RefusesToJudgeWithOtherArithmetic) {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8000);  // as crtfastmath.o does
  const testing::AssertionResult flushed = conforms(example, "projectile");
  _mm_setcsr(before);
  std::fesetround(FE_DOWNWARD);
  const testing::AssertionResult downward = conforms(example, "projectile");
  std::fesetround(FE_TONEAREST);
  for (const auto& found : {flushed, downward})
    EXPECT_NE(std::string(found.message()).find("-ffast-math"), std::string::npos) << found.message();
  EXPECT_CONFORMS(example, "projectile");
}

TEST(Conforms, NothingWithoutClaims) {
  EXPECT_FALSE(Conformity{}.conforms());
  EXPECT_EQ(Conformity{}.text(), "the scenario claims nothing\n");
}

TEST(Conforms, JudgesFilesToo) {
  EXPECT_TRUE(conform(example, (folder / "spring_orbit.toml").string(), "/nowhere").conforms());
  EXPECT_TRUE(conform(worker("in-house"), "mass_ratio_100", folder).conforms());  // of extremes/
}

}  // namespace
}  // namespace cylon::judge
