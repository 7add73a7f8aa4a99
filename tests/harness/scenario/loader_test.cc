// What a scenario file says arrives in the Scene, and what it leaves out has the documented default.
#include "harness/core/input_error.h"
#include "harness/scenario/input.h"
#include "harness/scenario/scenario.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;
using namespace cylon;
using scenario::parse;

const fs::path folder = fs::path(source_dir) / "scenarios";
const std::string head = "duration = 1\nstep = \"1/60\"\n";

TEST(Loader, DefaultsOfABody) {
  const auto s =
      parse(head +
                "[[body]]\nname = \"p\"\nmass = 3\n[[body]]\nname = \"s\"\nmass = 5\nposition = [3, 0, 0]\n"
                "shape = { type = \"sphere\", radius = 2 }\n",
            "dir/defaults.toml");
  EXPECT_EQ(s.name, "defaults");
  EXPECT_EQ(s.title, "defaults");
  EXPECT_EQ(s.step_text, "1/60");
  EXPECT_DOUBLE_EQ(s.step, 1.0 / 60);
  ASSERT_EQ(s.scene.bodies.size(), 2u);
  const core::Body &point = s.scene.bodies[0], &ball = s.scene.bodies[1];
  EXPECT_EQ(point.inertia, core::Matrix3(3 * core::Matrix3::Identity()));  // mass x 1 m^2
  EXPECT_FALSE(point.collide);
  EXPECT_EQ(point.initial.orientation.w(), 1);
  EXPECT_TRUE(ball.collide);
  EXPECT_DOUBLE_EQ(ball.inertia(0, 0), 0.4 * 5 * 4);
  EXPECT_TRUE(s.scene.forces.empty());  // no gravity unless stated
  EXPECT_FALSE(s.scene.frame);
  EXPECT_EQ(s.scene.impacts, core::Impacts::sequential);
}

TEST(Loader, StepsAreKeptAsWritten) {
  const auto step = [](const std::string& text) {
    return parse("duration = 1\nstep = " + text + " # s\n[[body]]\nname = \"a\"\nmass = 1\n", "a.toml")
        .step_text;
  };
  EXPECT_EQ(step("0.001"), "0.001");
  EXPECT_EQ(step("1e-3"), "1e-3");
  EXPECT_EQ(step("1"), "1");
  EXPECT_EQ(step("\"1/240\""), "1/240");
  EXPECT_EQ(scenario::parse_step("1/60"), 1.0 / 60);
  for (const char* bad :
       {"", "0", "-1", "1/", "/2", "1/2/3", "nan", "inf", "1e999", " 1", "1 ", "0x1", "1/-2"})
    EXPECT_THROW(scenario::parse_step(bad), core::InputError) << bad;
}

// Runs end at the last step, and a certified truth was not known there: an internal error.
TEST(Loader, DurationsOfFewDigitsEndWithTheLastStep) {
  const auto duration = [](const std::string& text) {
    return parse("duration = " + text + "\nstep = \"1/240\"\n[[body]]\nname = \"a\"\nmass = 1\n", "a.toml")
        .duration;
  };
  EXPECT_EQ(duration("2.08333333333"), 500 * (1. / 240));
  EXPECT_EQ(duration("2.0833333333333"), 2.0833333333333);  // to rounding
  EXPECT_EQ(duration("0.7"), 0.7);
  const auto s = parse(
      "duration = 2.08333333333\nstep = \"1/240\"\n[[body]]\nname = \"a\"\nmass = 1\nposition = [1, 0, 0]\n"
      "[[spring]]\nbody = \"a\"\npin = [0, 0, 0]\nstiffness = 3\n[[claim]]\nfollows = \"certified\"\n"
      "observable = \"position\"\ntolerance = { absolute = 1e-3, reason = \"r\" }\n",
      "b.toml");
  EXPECT_NO_THROW(s.claims[0].truth->state(500 * (1. / 240)));
}

TEST(Loader, ReadsEveryForceAndJoint) {
  const auto s = parse(head + R"(
gravity = [0, 0, -1]
impacts = "simultaneous"
frame = { velocity = [1, 2, 3], angular_velocity = [4, 5, 6] }
[[body]]
name = "a"
mass = 1
[[body]]
name = "b"
mass = 2
position = [0, 3, 4]
inertia = [2, 0.1, 0, 0.1, 2, 0, 0, 0, 3]
[[spring]]
body = "a"
anchor = [1, 0, 0]
to = "b"
to_anchor = [0, 1, 0]
stiffness = 7
rest_length = 0.5
damping = 0.25
[[drag]]
body = "b"
linear = 1
angular = 2
momentum = 3
[[thrust]]
body = "a"
mass_rate = -0.5
exhaust_velocity = [0, -9, 0]
[[drive]]
body = "a"
force = [1, 0, 0]
frequency = 2
[[attraction]]
body = "a"
to = "b"
strength = 6
[[water]]
level = 1
wave = 0.5
speed = 2
buoyancy = 1000
drag = 3
mode = "step"
[[joint]]
type = "distance"
body = "a"
to = "b"
[[joint]]
type = "hinge"
body = "b"
point = [0, 3, 5]
axis = [0, 0, 4]
)",
                       "all.toml");
  EXPECT_EQ(s.scene.impacts, core::Impacts::simultaneous);
  EXPECT_EQ(s.scene.frame->angular_velocity, core::Vector3(4, 5, 6));
  ASSERT_EQ(s.scene.forces.size(), 7u);
  EXPECT_EQ(std::get<core::UniformGravity>(s.scene.forces[0]).acceleration, core::Vector3(0, 0, -1));
  const auto& spring = std::get<core::Spring>(s.scene.forces[1]);
  EXPECT_EQ(spring.to, 1);
  EXPECT_EQ(spring.to_anchor, core::Vector3(0, 1, 0));
  EXPECT_EQ(spring.damping, 0.25);
  EXPECT_EQ(std::get<core::Drag>(s.scene.forces[2]).momentum, 3);
  EXPECT_EQ(*std::get<core::Thrust>(s.scene.forces[3]).exhaust_velocity, core::Vector3(0, -9, 0));
  EXPECT_EQ(std::get<core::Drive>(s.scene.forces[4]).frequency, 2);
  EXPECT_EQ(std::get<core::Attraction>(s.scene.forces[5]).strength, 6);
  EXPECT_EQ(std::get<core::Water>(s.scene.forces[6]).mode, "step");
  EXPECT_EQ(s.scene.bodies[1].inertia(1, 0), 0.1);
  ASSERT_EQ(s.scene.joints.size(), 2u);
  EXPECT_DOUBLE_EQ(s.scene.joints[0].length, 5);
  EXPECT_EQ(s.scene.joints[1].axis, core::Vector3(0, 0, 1));
  EXPECT_EQ(s.scene.joints[1].to, core::world);
}

// Velocities typed with few digits fit the joint as well as they can, and are then made to fit it exactly.
TEST(Loader, RoundedVelocitiesAreCompletedByTheJoint) {
  const auto s = parse(head +
                           "[[body]]\nname = \"top\"\nmass = 1\ninertia = [0.005, 0.01, 0.005]\n"
                           "position = [-0.08660254037844387, 0.05, 0]\nvelocity = [0, 0, -0.2598]\n"
                           "angular_velocity = [-40.27, 20.25, 0]\n[[joint]]\ntype = \"ball\"\nbody = "
                           "\"top\"\npoint = [0, 0, 0]\n",
                       "top.toml");
  const core::BodyState& top = s.scene.bodies[0].initial;
  EXPECT_LT((top.velocity - top.angular_velocity.cross(top.position)).norm(), 1e-15);
  EXPECT_NEAR(top.velocity.z(), -0.2598, 2e-6);
}

TEST(Loader, HashCoversTheBytes) {
  const std::string text = head + "[[body]]\nname = \"a\"\nmass = 1\n";
  EXPECT_EQ(parse(text, "a.toml").hash, parse(text, "b.toml").hash);
  EXPECT_NE(parse(text, "a.toml").hash, parse(text + "#", "a.toml").hash);
}

TEST(Loader, TheTemplateLoads) {
  const auto s = parse(scenario::template_toml("my \"scene\"\n"), "my.toml");
  EXPECT_EQ(s.title, "my scene");
  EXPECT_EQ(s.claims.size(), 2u);
}

TEST(Shipped, AllLoadWithStoryAndClaimsAtAMillisecond) {
  int count = 0;
  std::vector<fs::path> files;
  for (const fs::path& where : {folder, folder / "extremes"})
    for (const auto& entry : fs::directory_iterator(where))
      if (entry.path().extension() == ".toml" && entry.path().stem() != "expected")
        files.push_back(entry.path());
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.string());
    const auto s = scenario::load(file);
    ++count;
    EXPECT_FALSE(s.title.empty());
    EXPECT_GT(s.story.size(), 80u);
    EXPECT_FALSE(s.claims.empty());
    std::set<std::string> labels;
    for (const auto& claim : s.claims) {
      EXPECT_TRUE(labels.insert(claim.label).second) << claim.label;
      EXPECT_EQ(claim.truth.has_value(), !claim.follows.empty());
    }
  }
  EXPECT_GE(count, 140);
}

TEST(Shipped, ParametersOfTheReferenceScenes) {
  const auto body = [](const char* name) {
    return scenario::load(folder / (std::string(name) + ".toml")).scene.bodies[0];
  };
  EXPECT_EQ(body("projectile").initial.velocity, core::Vector3(3, 4, 0.5));
  EXPECT_EQ(body("spring_orbit").initial.velocity, core::Vector3(0, 3, 0));
  EXPECT_EQ(body("free_symmetric_top").initial.angular_velocity, core::Vector3(1, 0, 10));
  EXPECT_EQ(body("dzhanibekov").inertia.diagonal(), core::Vector3(1, 2, 3));
  const core::Body top = body("heavy_top");
  EXPECT_DOUBLE_EQ(top.initial.position.norm(), 0.3);
  EXPECT_DOUBLE_EQ(top.initial.angular_velocity.norm(), 60);
  const core::Vector3 axis = top.initial.orientation * core::Vector3::UnitY();
  EXPECT_LT((axis - top.initial.position / 0.3).norm(), 1e-15);
  EXPECT_LT((axis - top.initial.angular_velocity / 60).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(axis.y(), std::sqrt(3.0) / 2);
}

// Property: whatever bytes arrive, the loader returns a scenario or throws InputError; nothing else.
TEST(Fuzz, MutatedScenariosLoadOrGiveInputError) {
  const std::vector<std::string> seeds = {scenario::read_file(folder / "heavy_top.toml"),
                                          scenario::read_file(folder / "two_sphere_oblique.toml"),
                                          scenario::template_toml("fuzz")};
  std::mt19937 random(20240607);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  int loaded = 0, refused = 0;
  for (int round = 0; round < 1500; ++round) {
    std::string text = seeds[below(seeds.size())];
    for (std::size_t edits = 1 + below(4); edits > 0; --edits) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0:
          text[at] = static_cast<char>(random() & 255);
          break;
        case 1:
          text.erase(at, 1 + below(20));
          break;
        case 2:
          text.insert(at, text.substr(below(text.size()), below(40)));
          break;
        default:
          text.insert(at, 1, "[]{}=\"'.,-+0e#\n"[below(15)]);
          break;
      }
      if (text.empty()) text = " ";
    }
    try {
      parse(text, "fuzz.toml");
      ++loaded;
    } catch (const core::InputError&) {
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "round " << round << " threw " << error.what() << "\n" << text;
    }
  }
  EXPECT_GT(loaded, 50);  // comments and stories survive
  EXPECT_GT(refused, 500);
}

}  // namespace
