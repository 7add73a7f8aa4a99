// `cylon matrix`, what --force runs, and one exit code for "no engine can run this".
#include "tests/harness/cli/fixture.h"

#include <nlohmann/json.hpp>

namespace cylon::cli {
namespace {

class MatrixCommand : public CommandLine {};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(MatrixCommand, GivesTheCoarsestStepOfEachEngineAndNoStepOfAClosedForm) {
  const Ran ran = cylon("matrix projectile --engine in-house --engine ode --rounds 1 --json m.json");
  ASSERT_EQ(ran.code, 0) << ran.err;
  for (const char* part : {"projectile: 0.8 s, 1 body", "error 1e-2", "no steps", "closed form"})
    EXPECT_TRUE(contains(ran.out, part)) << part << '\n' << ran.out;
  const auto table = nlohmann::json::parse(read("m.json"))["tables"][0];
  ASSERT_EQ(table["cells"].size(), 2u);
  const auto& ode = table["series"][table["cells"][1]["series"].get<std::size_t>()];
  ASSERT_EQ(ode["engine"], "ode");
  const auto& reach = table["cells"][1]["reach"];
  ASSERT_EQ(reach.size(), 3u);
  // The error of semi-implicit Euler in free fall is g dt T/2 of the path: each digit takes ten times the
  // steps.
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_FALSE(reach[i]["point"].is_null()) << reach[i];
    const auto& point = ode["points"][reach[i]["point"].get<std::size_t>()];
    EXPECT_LE(point["errors"]["trajectory"], reach[i]["error"]);
    EXPECT_DOUBLE_EQ(point["dt"], i == 0 ? 0.008 : 0.0005);
  }
  EXPECT_TRUE(reach[2]["point"].is_null());
  EXPECT_EQ(reach[2]["why"], "needs about 80 µs at this order; cause: semi_implicit_euler");
  const double finest = ode["points"].back()["dt"];
  EXPECT_GE(finest, 1e-4);
  EXPECT_LT(finest, 1.1e-4);
}

TEST_F(MatrixCommand, LeavesOutTheInHouseEngineByOneFlag) {
  const Ran ran = cylon(
      "matrix projectile --engine 'in-house*' --engine ode --others --finest 0.004 --rounds 0 --at 0.01");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_FALSE(contains(ran.out, "in-house")) << ran.out;
  EXPECT_TRUE(contains(ran.out, "ode")) << ran.out;
  EXPECT_TRUE(contains(ran.out, "Digits: -log10")) << ran.out;
}

TEST_F(MatrixCommand, NamesTheCauseWhereAnErrorIsNotReached) {
  const Ran ran = cylon("matrix free_symmetric_top --engine bullet --finest 0.01 --rounds 0");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(contains(ran.out, "; cause: ")) << ran.out;
}

// `cylon advise` ended with 1 where `cylon trade` ended with 4.
TEST_F(MatrixCommand, NoEngineThatRunsTheSceneIsExitCode4) {
  for (const char* command : {"trade", "advise", "matrix"})
    EXPECT_EQ(cylon(std::string(command) + " spherical_pendulum --engine bullet --rounds 1").code, 4)
        << command;
  EXPECT_EQ(cylon("advise projectile --engine bullet/iterations=10 --tolerance 1e-9 --work 400").code, 1);
}

TEST_F(MatrixCommand, ForceShowsTheVerdictOfARefusedScene) {
  const std::string run = "run far_pyramid --engine in-house-float -v --json v.json";
  const auto first = [&] { return nlohmann::json::parse(read("v.json"))["verdicts"][0]; };
  cylon(run);
  EXPECT_EQ(first()["status"], "unsupported");
  cylon(run + " --force");
  EXPECT_NE(first()["status"], "unsupported");
  EXPECT_FALSE(first()["measured"].is_null()) << first();
  EXPECT_TRUE(contains(first()["detail"], "runs by force; else refused: 'box0_0' is 1e+07 m from the origin"))
      << first();
  EXPECT_TRUE(contains(first()["reproduce"], "--force"));
  // What an engine has no words for stays refused.
  cylon("run double_pendulum --engine bullet --json v.json --force");
  EXPECT_EQ(first()["status"], "unsupported");
}

}  // namespace
}  // namespace cylon::cli
