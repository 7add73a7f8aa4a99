// `cylon diff` on the engines that are built here, and on recordings.
#include "tests/harness/cli/fixture.h"

#include <nlohmann/json.hpp>

namespace cylon::cli {
namespace {

using nlohmann::json;

TEST_F(CommandLine, DiffOfARunWithItselfAgreesToTheBit) {
  const Ran ran = cylon("diff dzhanibekov in-house in-house --tolerance 0 --dt 0.01");
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("dzhanibekov: in-house and in-house agree at all "), std::string::npos) << ran.out;
}

// Without the gyroscopic torque the body keeps its angular velocity: it parts at once, in that.
TEST_F(CommandLine, DiffFindsFirstDifference) {
  const Ran ran = cylon("diff dzhanibekov bullet bullet/gyro=none --json");
  ASSERT_EQ(ran.code, 1) << ran.err;
  const json found = json::parse(ran.out);
  EXPECT_EQ(found["schema"], 1);
  ASSERT_FALSE(found["first"].is_null());
  const double time = found["first"]["time"];
  const std::string quantity = found["first"]["quantity"];
  bool seen = false;
  for (const json& curve : found["curves"]) {
    ASSERT_EQ(curve["distance"].size(), found["time"].size());
    for (std::size_t i = 0; i < found["time"].size(); ++i) {
      const double allowed = curve["largest"]["allowed"], d = curve["distance"][i];
      if (found["time"][i] < time) {
        EXPECT_LE(d, allowed);
      }
      if (found["time"][i] == time && curve["quantity"] == quantity) {
        EXPECT_GT(d, allowed);
        seen = true;
      }
      EXPECT_LE(d, double(curve["largest"]["distance"]));
    }
  }
  EXPECT_TRUE(seen);
}

TEST_F(CommandLine, DiffAtTwoStepsComparesCommonTimes) {
  const Ran ran = cylon("diff projectile in-house/integrator=explicit-euler@1/60 in-house@1/240 --json");
  ASSERT_EQ(ran.code, 1) << ran.err;
  const json found = json::parse(ran.out);
  EXPECT_NEAR(double(found["time"][1]), 1. / 60, 1e-15);
  // Explicit Euler falls g h t/2 too little.
  const json& position = found["curves"][0];
  ASSERT_EQ(position["first"].is_null(), false);
  const double t = found["time"].back(), d = position["distance"].back();
  EXPECT_NEAR(d, 9.81 / 60 * t / 2, 1e-9 * d);
}

TEST_F(CommandLine, DiffReadsWhatSimulateWrote) {
  ASSERT_EQ(cylon("simulate heavy_top --engine in-house --integrator rk4 --every 0.1 --out a.csv").code, 0);
  const Ran same = cylon("diff heavy_top in-house/integrator=rk4 a.csv --tolerance 0");
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  EXPECT_NE(same.out.find("agree at all 101 common times"), std::string::npos) << same.out;
  const std::string whole = read("a.csv");
  write("cut.csv", whole.substr(0, whole.find("\n5,") + 1));  // a file that was cut agreed
  const Ran cut = cylon("diff heavy_top in-house/integrator=rk4 cut.csv --tolerance 0");
  EXPECT_EQ(cut.code, 1) << cut.out;
  EXPECT_NE(cut.err.find("cut.csv ends at 4.9 s, the scene at 10 s"), std::string::npos) << cut.err;
  const Ran other = cylon("diff heavy_top a.csv in-house/integrator=yoshida4 --tolerance 0 --csv -");
  EXPECT_EQ(other.code, 1) << other.err;
  EXPECT_EQ(other.out.substr(0, other.out.find('\n')),
            "time,position,orientation,velocity,angular_velocity,linear_momentum,angular_momentum,energy");
}

TEST_F(CommandLine, DiffRefusals) {
  ASSERT_EQ(cylon("simulate projectile --at 0,0.5 --out good.csv").code, 0);
  const std::string good = read("good.csv");
  const std::string header = good.substr(0, good.find('\n') + 1), name = "projectile";
  write("empty.csv", "");
  write("header.csv", header);
  write("short.csv", header + "0,a,1,2\n");
  write("word.csv", replaced(good, "0.5,", "0.5x,"));
  write("stranger.csv", header + "0,nobody,0,0,0,1,0,0,0,0,0,0,0,0,0\n");
  write("back.csv", good + good.substr(header.size()));
  const struct {
    const char *arguments, *says;
  } cases[] = {
      {"projectile in-house empty.csv", "empty.csv:1:1: the first line must be 'time,body,"},
      {"projectile in-house header.csv", "no states"},
      {"projectile in-house short.csv", "short.csv:2:1: 15 columns are needed"},
      {"projectile in-house word.csv", "word.csv:2:1: column 12: '0.5x' is not a number"},
      {"projectile in-house stranger.csv", "stranger.csv:2:1: column 2: the scene has no body 'nobody'"},
      {"projectile in-house back.csv", "does not follow"},
      {"projectile in-house missing.csv", "missing.csv: cannot be read"},
      {"projectile in-house@0.3 good.csv", "in-house@0.3: the duration of projectile"},
      {"projectile in-house bulet", "did you mean 'bullet'?"},
      {"projectle in-house bullet", "did you mean 'projectile'?"},
      {"projectile in-house bullet --tolerance -1", "--tolerance"},
  };
  for (const auto& c : cases) {
    const Ran ran = cylon(std::string("diff ") + c.arguments);
    EXPECT_EQ(ran.code, 2) << c.arguments << ran.out;
    EXPECT_NE(ran.err.find(c.says), std::string::npos) << c.arguments << "\n" << ran.err;
  }
}

}  // namespace
}  // namespace cylon::cli
