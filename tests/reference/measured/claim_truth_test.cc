// Scenarios whose claims follow measured motions: what the truth is, and what is refused, with file, line, key and value.
#include "reference/measured/claim_truth.h"

#include "harness/core/claim.h"
#include "harness/core/input_error.h"
#include "reference/measured/coordinates.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

namespace cylon::measured {
namespace {

namespace fs = std::filesystem;

// A ball that was thrown, in frames of 0.1 s, and an arm that swings.
const std::string ball =
    "[[body]]\nname = \"ball\"\nmass = 2\nposition = [1, 2, 3]\nvelocity = [0.5, 1, -0.25]\n"
    "orientation = [0.6, 0.8, 0, 0]\nangular_velocity = [0.1, 0.2, 0.3]\n"
    "shape = { type = \"sphere\", radius = 0.1 }\n";
const std::string throws =
    "title = \"t\"\nsource = \"who\"\nlicence = \"l\"\ndata = \"ball.csv\"\nmodel = \"ball.toml\"\nbody = "
    "\"ball\"\n"
    "rate = 10\n[columns]\nrun = \"n\"\nposition = [\"x\", \"y\", \"z\"]\norientation = [\"a\", \"b\", "
    "\"c\", \"d\"]\n"
    "velocity = [\"u\", \"v\", \"w\"]\nangular_velocity = [\"p\", \"q\", \"r\"]\n";
const std::string errors =
    "[uncertainty]\nnoise = 0.01\nangle_noise = 0.02\nposition = 0.01\nvelocity = 0.03\n";
const std::string ball_table =
    "n,x,y,z,a,b,c,d,u,v,w,p,q,r\n"
    "1,1,2,3,0.6,0.8,0,0,0.5,1,-0.25,0.1,0.2,0.3\n"
    "1,1.05,2.1,2.975,0.6,0.8,0,0,0.5,1,-0.25,0.1,0.2,0.3\n"
    "1,1.1,2.2,2.95,0.6,0.8,0,0,0.5,1,-0.25,0.1,0.2,0.3\n"
    "2,0,0,0,1,0,0,0,0,0,0,0,0,0\n2,0,0,0,1,0,0,0,0,0,0,0,0,0\n";
const std::string head = "duration = 0.2\nstep = 0.05\n";
const std::string claim =
    "[[claim]]\nfollows = { measured = \"e.toml\", run = \"1\" }\nobservable = \"position\"\n"
    "tolerance = { absolute = 0.1, reason = \"convention\" }\n";

std::string with(std::string text, const std::string& what, const std::string& instead) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), instead);
}

class MeasuredTruths : public testing::Test {
 protected:
  void SetUp() override {
    serve_scenarios();
    folder_ = fs::temp_directory_path() /
              (std::string("cylon-measured-truth-") +
               testing::UnitTest::GetInstance()->current_test_info()->name() + std::to_string(::getpid()));
    fs::create_directories(folder_);
    put("ball.toml", head + ball), put("ball.csv", ball_table), put("e.toml", throws + errors);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void put(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  scenario::Scenario parsed(const std::string& text) const {
    put("s.toml", text);
    return scenario::load(folder_ / "s.toml");
  }
  std::string why(const std::string& text) const {
    try {
      parsed(text);
    } catch (const core::InputError& error) {
      return error.what();
    }
    return "taken";
  }

  fs::path folder_;
};

TEST_F(MeasuredTruths, AreKnownAtFramesAfterTheFirst) {
  const scenario::Scenario s = parsed(head + ball + claim);
  const core::Claim& c = s.claims.at(0);
  EXPECT_EQ(c.label, "position follows measured e.toml, run 1");
  EXPECT_TRUE(core::validates(c));
  EXPECT_EQ(core::evidence(c), "validated");
  EXPECT_FALSE(core::measures_motion(c)) << "studies of an engine's errors leave it out";
  EXPECT_TRUE(std::isnan(c.truth_error)) << "noise has no bound";
  EXPECT_EQ(c.truth->times, (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(c.truth->state(0.2)[0].position, core::Vector3(1.1, 2.2, 2.95));
  EXPECT_THROW(c.truth->state(0.15), std::invalid_argument);
  EXPECT_EQ(c.truth->source, "who");
  EXPECT_EQ(c.uncertainty->scenes.size(), 6u) << "three of the place, three of the velocity";
  const auto& [up, down] = c.uncertainty->scenes[5];
  EXPECT_NEAR(up.bodies[0].initial.velocity.z(), -0.22, 1e-12);
  EXPECT_NEAR(down.bodies[0].initial.velocity.z(), -0.28, 1e-12);
  const auto noise = c.uncertainty->measured(0.1);
  ASSERT_EQ(noise.size(), 6u) << "place and turn";
  EXPECT_NEAR(noise[1].first[0].position.y(), 2.11, 1e-12);
  EXPECT_NEAR(noise[4].first[0].orientation.angularDistance(noise[4].second[0].orientation), 0.04, 1e-12);
}

TEST_F(MeasuredTruths, TakeFramesThatTheSampleComesBy) {
  const auto times = [&](const std::string& more) {
    return parsed(head + ball + claim + more).claims[0].truth->times;
  };
  EXPECT_EQ(times("sample = 0.2\n"), std::vector<double>{0.2});
  EXPECT_EQ(times("until = 0.1\n"), std::vector<double>{0.1});
  EXPECT_EQ(times("sample = \"step\"\n").size(), 2u);
}

TEST_F(MeasuredTruths, HoldSurfacesAsUncertain) {
  const std::string surface =
      "[[plane]]\nname = \"table\"\nnormal = [0, 1, 0]\noffset = -5.0\n"
      "[[material]]\nbetween = [\"ball\", \"table\"]\nfriction = 0.3\nrestitution = 0.95\n";
  put("e.toml", throws + errors + "friction = 0.05\nrestitution = 0.02\n");
  const auto s = parsed(head + ball + surface + claim);
  const auto& scenes = s.claims[0].uncertainty->scenes;
  ASSERT_EQ(scenes.size(), 8u);
  EXPECT_DOUBLE_EQ(scenes[6].first.materials[0].friction, 0.35);
  EXPECT_DOUBLE_EQ(scenes[7].second.materials[0].restitution, 0.93);
  put("e.toml", throws + errors + "restitution = 0.06\n");
  EXPECT_NE(why(head + ball + surface + claim)
                .find("the restitution of 'ball' and 'table' is 0.95, and may be off by "
                      "0.06: more than there is"),
            std::string::npos);
}

// The scene states the arm where its run starts; the description's model has it hang.  Inertia and length are the scene's own.
TEST_F(MeasuredTruths, OfChainsAreTurnedIntoTheScene) {
  const auto arm = [](const std::string& state) {
    return "[[body]]\nname = \"arm\"\nmass = 1\ninertia = [0.1, 0.1, 0.1]\nshape = { type = \"box\", "
           "half_extents = "
           "[0.1, 0.5, 0.1] }\ncollide = false\n" +
           state +
           "[[joint]]\nname = \"pivot\"\ntype = \"hinge\"\nbody = \"arm\"\npoint = [0, 0, 0]\naxis = [0, 0, "
           "1]\n";
  };
  put("arm.toml", head + arm("position = [0, -0.5, 0]\n"));
  put("arm.csv", "n,a,b\n4,210,60\n4,216,60\n4,222,60\n");  // 30 degrees from the way down, 1.0472 rad/s
  put("e.toml",
      "title = \"t\"\nsource = \"who\"\nlicence = \"l\"\ndata = \"arm.csv\"\nmodel = \"arm.toml\"\nbodies = "
      "[\"arm\"]\nrate = 10\n[columns]\nrun = \"n\"\nangles = [\"a\"]\nrates = [\"b\"]\n[units]\nangle = "
      "\"deg\"\nzero = 180\n[uncertainty]\nangle_noise = 0.002\nangle = 0.002\nrate = 0.03\n");
  const std::string swing = with(with(claim, "\"1\"", "\"4\""), "position", "joint_angle");
  const std::string hangs = why(head + arm("position = [0, -0.4, 0]\n") + swing);
  // x = 0.4 sin 30°, y = -0.4 cos 30°; v = rate x arm
  EXPECT_NE(hangs.find("s.toml:"), std::string::npos) << hangs;
  EXPECT_NE(
      hangs.find("the scene does not start as run 4 does; it needs 'arm' position = [0.2, -0.3464101615, 0]"),
      std::string::npos)
      << hangs;
  EXPECT_NE(hangs.find("velocity = [0.3627598728, 0.2094395102, 0], angular_velocity = [0, 0, 1.047197551]"),
            std::string::npos)
      << hangs;
  const scenario::Scenario s =
      parsed(head +
             arm("position = [0.2, -0.3464101615, 0]\norientation = [0.9659258262890683, 0, 0, "
                 "0.25881904510252074]\n"
                 "velocity = [0.3627598729, 0.2094395102, 0]\nangular_velocity = [0, 0, 1.047197551]\n") +
             swing);
  const core::Claim& c = s.claims[0];
  core::Values values;
  core::evaluate(c.observable, s.scene, c.truth->state(0.2), values);
  EXPECT_NEAR(values[0].x(), 12 * std::numbers::pi / 180, 1e-9) << "from the scene's start on";
  ASSERT_EQ(c.uncertainty->scenes.size(), 2u);
  const core::Scene& turned = c.uncertainty->scenes[0].first;
  EXPECT_NEAR(turned.bodies[0].initial.position.norm(), 0.4, 1e-9);
  EXPECT_NEAR(std::atan2(turned.bodies[0].initial.position.x(), -turned.bodies[0].initial.position.y()),
              std::numbers::pi / 6 + 0.002, 1e-8);
  EXPECT_NEAR(turned.joints[0].point.norm(), 0, 1e-9) << "still hung at the pivot";
  EXPECT_NEAR(c.uncertainty->scenes[1].second.bodies[0].initial.angular_velocity.z(),
              std::numbers::pi / 3 - 0.03, 1e-8);
}

TEST_F(MeasuredTruths, RefuseWhatCannotBe) {
  const std::string good = head + ball + claim;
  const struct {
    std::string what, description, text, says;
  } cases[] = {
      {"no such file", throws + errors, with(good, "e.toml", "f.toml"), "f.toml: no such file"},
      {"no such run", throws + errors, with(good, "run = \"1\"", "run = \"11\""),
       "run = '11': there is none in"},
      {"no run", throws + errors, with(good, ", run = \"1\"", ""), "'measured' and 'run' go together"},
      {"a run of a file", throws + errors, with(good, "measured", "file"),
       "'measured' and 'run' go together"},
      {"both", throws + errors, with(good, "{ measured", "{ file = \"x\", measured"),
       "needs either 'file' or 'measured'"},
      {"an unknown key", throws + errors, with(good, "run =", "runs ="), "runs"},
      {"a bad description", with(throws, "rate = 10", "rate = -10") + errors, good, "e.toml:7:"},
      {"its value", with(throws, "rate = 10", "rate = -10") + errors, good, "rate = -10"},
      {"no noise", throws + with(errors, "noise = 0.01\n", ""), good, "[uncertainty] states no noise"},
      {"no errors of the start", throws + "[uncertainty]\nnoise = 0.01\n", good,
       "[uncertainty] states no error of the start"},
      {"an orientation without noise", throws + with(errors, "angle_noise = 0.02\n", ""),
       with(good, "observable = \"position\"", "observable = \"orientation\""),
       "observable: of 'orientation', measured e.toml, run 1 states no noise"},
      {"what was not measured", throws + errors,
       with(good, "observable = \"position\"", "observable = \"velocity\""),
       "observable: 'velocity' was not measured"},
      {"a relative tolerance", throws + errors, with(good, "absolute", "relative"),
       "tolerance: that of a measured motion is absolute alone"},
      {"a mean square", throws + errors, good + "measure = \"mean_square\"\n", "measure: 'mean_square'"},
      {"another start", throws + errors, with(good, "position = [1, 2, 3]", "position = [1, 2, 3.001]"),
       "the scene does not start as run 1 does; it needs 'ball' position = [1, 2, 3]"},
      {"another spin", throws + errors, with(good, "[0.1, 0.2, 0.3]", "[0.1, 0.2, 0.31]"),
       "angular_velocity = [0.1, 0.2, 0.3]"},
      {"another name", throws + errors, with(good, "name = \"ball\"", "name = \"balls\""),
       "the measured body 'ball' is not in the scene, did you mean 'balls'?"},
      {"another body that moves", throws + errors,
       head + ball + with(with(ball, "\"ball\"", "\"other\""), "[1, 2, 3]", "[9, 2, 3]") +
           "collide = false\n" + claim,
       "'other' moves, and was not measured"},
      {"a joint", throws + errors,
       head +
           "[[body]]\nname = \"ball\"\nmass = 2\nshape = { type = \"sphere\", radius = 0.1 "
           "}\n[[joint]]\ntype = "
           "\"ball\"\nbody = \"ball\"\npoint = [0, 0.5, 0]\n" +
           with(claim, "\"1\"", "\"2\""),
       "a joint holds it"},
      {"a run that ends before", throws + errors, with(good, "duration = 0.2", "duration = 0.3"),
       "until: measured e.toml, run 1 ends at 0.2 s, and the claim at 0.3 s"},
      {"frames between samples", throws + errors, good + "sample = 0.15\n", "no frame of the data comes by"},
      {"frames between steps", throws + errors, with(good, "step = 0.05", "step = 0.2"),
       "a time of the recorded data"},
  };
  for (const auto& [what, description, text, says] : cases) {
    put("e.toml", description);
    const std::string said = why(text);
    EXPECT_NE(said.find(says), std::string::npos) << what << ": " << said;
    EXPECT_NE(said.find("s.toml:"), std::string::npos) << what << ": " << said;
  }
}

// A model is a scenario file: it could name the description that names it.
TEST_F(MeasuredTruths, OfModelsDoNotFollowMeasuredMotions) {
  put("ball.toml", head + ball + claim);
  EXPECT_NE(why(head + ball + claim).find("the model of an experiment follows no measured motion"),
            std::string::npos);
}

// Data and description are part of what the scenario is.
TEST_F(MeasuredTruths, EnterTheHash) {
  const std::string before = parsed(head + ball + claim).hash;
  put("ball.csv", with(ball_table, "2.95", "2.96"));
  EXPECT_NE(parsed(head + ball + claim).hash, before);
}

}  // namespace
}  // namespace cylon::measured
