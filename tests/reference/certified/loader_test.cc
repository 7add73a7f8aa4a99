// `follows = "certified"` and `until = "horizon"` in a scenario file.
#include "harness/core/input_error.h"
#include "harness/core/measure.h"
#include "harness/core/scale.h"
#include "harness/scenario/scenario.h"
#include "tests/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace cylon::scenario {
namespace {

class CertifiedClaims : public testing::Test {
 protected:
  void SetUp() override { ::setenv("CYLON_CACHE", own_.path().c_str(), 1); }
  void TearDown() override { ::unsetenv("CYLON_CACHE"); }
  const TemporaryFolder own_;
};

// Two bobs on rods, as chaotic as it gets; `duration` and a claim follow.
std::string bobs(double duration, const std::string& claim, const std::string& more = "") {
  return fmt::format(R"(
duration = {}
step = 0.001
gravity = [0, -9.81, 0]
[[body]]
name = "one"
mass = 1
position = [0.6, 0.8, 0]
[[body]]
name = "two"
mass = 0.7
position = [1.2, 1.6, 0]
[[joint]]
type = "distance"
body = "one"
point = [0, 0, 0]
[[joint]]
type = "distance"
body = "two"
to = "one"
{}
[[claim]]
follows = "certified"
observable = "position"
{}
)",
                     duration, more, claim);
}

const std::string thousandth = "tolerance = { absolute = 1e-3, reason = \"a thousandth of the rods\" }\n";

std::string complaint(const std::string& text) {
  try {
    parse(text, "bobs.toml");
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST_F(CertifiedClaims, HaveErrorBoundAtAnyTime) {
  const Scenario scenario = parse(bobs(1, thousandth), "bobs.toml");
  const core::Claim& claim = scenario.claims.at(0);
  EXPECT_EQ(claim.label, "position follows certified");
  ASSERT_TRUE(claim.truth.has_value());
  EXPECT_TRUE(claim.truth->times.empty());
  EXPECT_LT(claim.truth_error, 1e-14);
  EXPECT_NEAR(claim.truth->state(0.123)[0].position.norm(), 1, 1e-14);
}

// Reading a file integrates nothing; what it gives cannot be judged before it is prepared.
TEST_F(CertifiedClaims, AreSolvedByPrepareAndNotByRead) {
  const std::filesystem::path file = own_.path() / "bobs.toml";
  std::ofstream(file) << bobs(1, thousandth);
  Scenario scenario = read(file);
  EXPECT_FALSE(scenario.claims.at(0).truth.has_value());
  EXPECT_THROW(require_prepared(scenario), std::logic_error);
  EXPECT_THROW(core::scale(scenario.claims[0], scenario.scene, 1), std::logic_error);

  prepare(scenario);
  EXPECT_NO_THROW(require_prepared(scenario));
  const Scenario parsed = parse(bobs(1, thousandth), "bobs.toml");
  ASSERT_TRUE(scenario.claims[0].truth.has_value());
  EXPECT_EQ(scenario.claims[0].truth_error, parsed.claims[0].truth_error);
  EXPECT_EQ(scenario.claims[0].label, parsed.claims[0].label);
}

// The place of the claim is known still when its truth is looked at.
TEST_F(CertifiedClaims, ThatFailWhenTheyArePreparedSayWhere) {
  const std::filesystem::path file = own_.path() / "bobs.toml";
  std::ofstream(file) << bobs(60, thousandth);
  Scenario scenario = read(file);
  try {
    prepare(scenario);
    ADD_FAILURE() << "accepted";
  } catch (const core::InputError& error) {
    EXPECT_EQ(std::string(error.what()).find(file.string() + ":23:"), 0u) << error.what();
  }
}

// An ulp times the conditioning reaches a tenth of the tolerance: a thousand times the tolerance is later by
// a fixed time, not a thousand times later.
TEST_F(CertifiedClaims, HorizonIsWhereOneUlpMatters) {
  const auto horizon = [&](double tolerance) {
    const std::string claim = fmt::format(
        "until = \"horizon\"\ntolerance = {{ absolute = {}, reason = \"convention: some fraction of a rod\" "
        "}}\n",
        tolerance);
    const Scenario scenario = parse(bobs(30, claim), "bobs.toml");
    EXPECT_EQ(scenario.claims[0].label,
              fmt::format("position follows certified, until horizon {}", scenario.claims[0].until));
    return scenario.claims[0].until;
  };
  const double loose = horizon(1e-3), middle = horizon(1e-6), strict = horizon(1e-9);
  EXPECT_LT(strict, middle);
  EXPECT_LT(middle, loose);
  EXPECT_LT(loose, 30);
  EXPECT_GT(strict, 1);
  EXPECT_LT(loose, 3 * middle);
  EXPECT_NEAR(std::remainder(loose, 30.0 / 200), 0, 1e-9);
}

TEST_F(CertifiedClaims, HaveNoTruthBeyondHorizon) {
  EXPECT_NE(complaint(bobs(60, thousandth)).find("no engine can follow; say until = \"horizon\""),
            std::string::npos);
}

TEST_F(CertifiedClaims, ErrorGivesReason) {
  const std::string touching = R"(
[[plane]]
name = "floor"
normal = [0, 1, 0]
offset = -5
[[material]]
between = ["*", "*"]
restitution = 0.5
friction = 0
)";
  std::string ball = bobs(1, thousandth, touching);
  ball.insert(ball.find("mass = 0.7"), "shape = { type = \"sphere\", radius = 0.1 }\ncollide = true\n");
  EXPECT_NE(complaint(ball).find("may touch, and a blow is not smooth"), std::string::npos)
      << complaint(ball);

  std::string other = bobs(1, "until = \"horizon\"\n" + thousandth);
  other.replace(other.find("\"certified\""), 11, "\"projectile\"");
  EXPECT_NE(complaint(other).find("belongs to follows = \"certified\""), std::string::npos)
      << complaint(other);

  const std::string word = complaint(bobs(1, "until = \"horizn\"\n" + thousandth));
  EXPECT_NE(word.find("did you mean 'horizon'?"), std::string::npos) << word;
  const std::string kind = complaint(bobs(1, "until = true\n" + thousandth));
  EXPECT_NE(kind.find("a number or \"horizon\""), std::string::npos) << kind;

  std::string name = bobs(1, thousandth);
  name.replace(name.find("\"certified\""), 11, "\"certifed\"");
  EXPECT_NE(complaint(name).find("did you mean 'certified'?"), std::string::npos) << complaint(name);

  const std::string order =
      "until = \"horizon\"\ntolerance = { order = true, constant = 1, reason = \"truncation: rk4\" }\n";
  EXPECT_NE(complaint(bobs(1, order)).find("absolute or relative"), std::string::npos);
}

}  // namespace
}  // namespace cylon::scenario
