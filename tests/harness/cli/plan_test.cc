// `cylon plan`, and tolerances on the command line, against a worker that has both.
#include "tests/harness/cli/fixture.h"
#include "tests/paths.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace cylon::cli {
namespace {

using nlohmann::json;

const std::string controlled = " --engine mine --worker 'mine=python3 " + std::string(source_dir) +
                               "/tests/harness/process/scripted_worker.py adaptive'";
const std::string foreign =
    " --engine mine --worker 'mine=python3 " + std::string(source_dir) + "/docs/examples/foreign_engine.py'";

TEST_F(CommandLine, PlanPrintsEveryStageWithItsReason) {
  const Ran ran = cylon("plan projectile" + controlled);
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out,
            "projectile on mine, integrator uniform\n"
            "  in   flight               bodies move\n"
            "  out  far too \\x1b[31mred  nothing is\n");
}

TEST_F(CommandLine, PlanAsJson) {
  const Ran ran = cylon("plan projectile --json" + controlled);
  ASSERT_EQ(ran.code, 0) << ran.err;
  const json plan = json::parse(ran.out);
  EXPECT_EQ(plan.at("scenario"), "projectile");
  ASSERT_EQ(plan.at("plan").size(), 2u);
  EXPECT_EQ(plan.at("plan").at(0), (json{{"name", "flight"}, {"in", true}, {"reason", "bodies move"}}));
}

TEST_F(CommandLine, PlanAndToleranceRefusals) {
  const struct {
    std::string arguments;
    int code;
    const char* says;
  } cases[] = {
      {"plan projectile" + foreign, 2, "engine 'mine' reports no plan"},
      {"plan projectle", 2, "did you mean 'projectile'?"},
      {"plan heavy_top" + foreign, 2, "unsupported: no joint"},
      {"plan projectile --engine bulet", 2, "did you mean 'bullet'?"},
      {"plan projectile --model full" + foreign, 2,
       "--model: engine 'mine' has no option 'model'; it is for the in-house engine alone"},
      {"plan projectile --dt 1ms", 2, "--dt: '1ms' is no step"},
      {"plan projectile --engine in-house/model=planned --model full", 2, "states another"},
      {"simulate projectile --tolerance 1e-6" + foreign, 2, "has no integrator with error control"},
      {"simulate projectile --tolerance 1e-6" + controlled, 2, "(integrators that do: controlled)"},
      {"simulate projectile --tolerance 0", 2, "must be a number > 0"},
      {"simulate projectile --tolerance -1", 2, "must be a number > 0"},
      {"simulate projectile --tolerance 1e-6 --at 0.1234567,0.2 --integrator controlled" + controlled, 2,
       "no common step"},
  };
  for (const auto& c : cases) {
    const Ran ran = cylon(c.arguments);
    EXPECT_EQ(ran.code, c.code) << c.arguments << ran.err;
    EXPECT_NE(ran.err.find(c.says), std::string::npos) << c.arguments << "\n" << ran.err;
  }
}

// With a tolerance and no step the times that are asked for are the grid; remarks go to stderr.
TEST_F(CommandLine, ToleranceNeedsNoStep) {
  const std::string common = "simulate projectile --tolerance 1e-6 --integrator controlled" + controlled;
  const Ran ran = cylon(common + " --at 0,0.12345,0.7");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("mine: tolerance 1e-06 was not reached: 0.5 was\n"), std::string::npos) << ran.err;
  std::istringstream lines(ran.out);
  std::string line;
  std::getline(lines, line);
  for (const double t : {0.0, 0.12345, 0.7}) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_NEAR(std::stod(line), t, 1e-15);
  }
  EXPECT_FALSE(std::getline(lines, line));
  EXPECT_EQ(cylon(common + " --dt 0.1 --at 0.15").code, 2) << "--dt states the grid";
  const Ran every = cylon(common + " --every 0.3");
  ASSERT_EQ(every.code, 0) << every.err;
  EXPECT_EQ(std::count(every.out.begin(), every.out.end(), '\n'), 4);  // head, 0, 0.3, 0.6
}

// A remark stands in the row that it concerns.
TEST_F(CommandLine, RemarksAppearInRows) {
  const Ran ran = cylon("run projectile --json -" + controlled);
  const json verdicts = json::parse(ran.out).at("verdicts");
  ASSERT_FALSE(verdicts.empty());
  for (const json& row : verdicts)
    EXPECT_NE(row.at("detail").get<std::string>().find("tolerance 0 was not reached"), std::string::npos);
}

// What an engine says of its run as data: in words with `plan` and `run -v`, whole in JSON.
TEST_F(CommandLine, DiagnosticsAreShown) {
  const std::string stepped = " bouncing_sphere --engine in-house/path=stepping";
  const std::string said =
      "path stepping: fixed steps of order 1 in dt = 0.001 s; the error is not controlled";
  EXPECT_NE(cylon("plan" + stepped).out.find("\n  " + said + "\n"), std::string::npos);
  const Ran ran = cylon("run -v" + stepped);
  EXPECT_NE(
      ran.out.find("  diagnostic: error-not-controlled: " + said + " [fixed steps with impulses, order 1]\n"),
      std::string::npos)
      << ran.out;
  const json planned = json::parse(cylon("plan --json" + stepped).out);
  EXPECT_EQ(planned.at("diagnostics").at(0).at("kind"), "error-not-controlled");
  const json verdicts = json::parse(cylon("run --json -" + stepped).out).at("verdicts");
  ASSERT_FALSE(verdicts.empty());
  for (const json& row : verdicts) {
    const json& first = row.at("diagnostics").at(0);
    EXPECT_EQ(first.at("kind"), "error-not-controlled");
    EXPECT_EQ(first.at("bodies"), json::array({"ball"}));
    EXPECT_EQ(first.at("method"), "fixed steps with impulses");
    EXPECT_EQ(first.at("text"), said);
    EXPECT_TRUE(first.at("limit").is_null());
  }
}

// The in-house engine behind the same door: its plan, its model option, and a tolerance that it takes.
TEST_F(CommandLine, InHousePlansAndTakesATolerance) {
  const auto stage = [](const json& plan, const std::string& name) {
    for (const json& row : plan.at("plan"))
      if (row.at("name") == name) return row;
    ADD_FAILURE() << "no stage " << name;
    return json();
  };
  const json planned = json::parse(cylon("plan spring_zero_length --json").out);
  const json full = json::parse(cylon("plan spring_zero_length --model full --json").out);
  EXPECT_FALSE(stage(planned, "rotation").at("in").get<bool>());
  EXPECT_TRUE(stage(full, "rotation").at("in").get<bool>());
  EXPECT_TRUE(stage(planned, "springs").at("in").get<bool>());
  EXPECT_FALSE(stage(planned, "detection").at("reason").get<std::string>().empty());
  for (const auto& [joints, kept] : {std::pair{"reduced", false}, std::pair{"constraints", true}}) {
    const std::string engine = std::string(" --engine in-house/joints=") + joints;
    const json plan = json::parse(cylon("plan heavy_top --json" + engine).out);
    EXPECT_EQ(stage(plan, "joint constraints").at("in").get<bool>(), kept) << joints;
  }
  EXPECT_EQ(cylon("simulate spring_zero_length --tolerance 1e-6 --at 0.7654").code, 0);
  EXPECT_NE(cylon("simulate spring_zero_length --tolerance 1e-6 --integrator rk4")
                .err.find("integrators that do: auto"),
            std::string::npos);
  EXPECT_NE(cylon("plan projectile --model ful").err.find("did you mean 'full'?"), std::string::npos);
  EXPECT_NE(cylon("engines in-house").out.find("takes a tolerance"), std::string::npos);
}

// Galilei: a frame that only moves changes nothing; one that turns does.
TEST_F(CommandLine, UniformlyMovingFrameChangesNothing) {
  const std::string whole = shipped("spring_orbit");
  const std::string scene = whole.substr(0, whole.find("[[claim]]"));
  const auto run = [&](const std::string& frame) {
    write("mine.toml", scene + frame);
    const Ran ran = cylon("simulate mine.toml --integrator rk4 --at 1");
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.out;
  };
  const std::string rest = run("");
  EXPECT_EQ(run("\n[frame]\nvelocity = [3, -2, 0.5]\n"), rest);
  EXPECT_NE(run("\n[frame]\nangular_velocity = [0.1, 0.2, -0.3]\n"), rest);
}

// Input that no motion follows from is an error before the run, or a message after it, never silence.
TEST_F(CommandLine, TruthGivesReasonWhenItCannotCertify) {
  const std::string head = "title = 'x'\nstory = 'x'\nduration = 1.0\nstep = 0.01\n";
  const std::string ball = "[[body]]\nname = 'a'\nmass = 1\nposition = [1, 0, 0]\n";
  const struct {
    std::string text, options;
    int code;
    const char* says;
  } cases[] = {
      {ball + "[[spring]]\nbody = 'a'\npin = [0, 0, 0]\nstiffness = 1e6\n", "--integrator velocity-verlet", 1,
       "faster than light"},
      {ball + "[[spring]]\nbody = 'a'\npin = [0, 0, 0]\nstiffness = 1e6\n", "--dt 0", 2, "'0' is no step"},
      {ball + "[[body]]\nname = 'b'\nmass = 1\nposition = [2, 0, 0]\n[[attraction]]\nbody = 'a'\nto = 'b'\n"
              "strength = 4\n",
       "", 1, "non-finite"},
      {ball + "collide = true\nshape = { type = 'disc', radius = 0.1 }\n[[plane]]\nname = "
              "'floor'\n"
              "normal = [1, 0, 0]\n[[material]]\nbetween = ['*', '*']\nrestitution = 0\nfriction = 0\n",
       "", 2, "unsupported: body 'a' may touch, but is a disc"},
  };
  for (const auto& c : cases) {
    write("mine.toml", head + c.text);
    const Ran ran = cylon("simulate mine.toml --at 1 " + c.options);
    EXPECT_EQ(ran.code, c.code) << c.text << ran.err;
    EXPECT_NE(ran.err.find(c.says), std::string::npos) << c.text << ran.err;
  }
}

}  // namespace
}  // namespace cylon::cli
