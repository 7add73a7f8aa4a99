// Scenes that no equation of the certified solution describes are refused, with the reason.
#include "reference/certified/solve.h"

#include <gtest/gtest.h>

#include <functional>

namespace cylon::certified {
namespace {

core::Scene ball_in_the_air() {
  core::Scene scene;
  core::Body ball;
  ball.name = "ball";
  ball.shape = core::Sphere{0.1};
  ball.mass = 0.7;
  ball.initial.position = {0.2, 1.5, -0.3};
  scene.bodies = {ball};
  scene.forces.emplace_back(core::UniformGravity{});
  return scene;
}

struct Refusal {
  const char* name;
  std::function<void(core::Scene&)> change;
  const char* reason;
};
void PrintTo(const Refusal& r, std::ostream* out) { *out << r.name; }

const Refusal refusals[] = {
    {"contact",
     [](core::Scene& s) {
       s.bodies[0].collide = true;
       s.planes.push_back({"floor", core::Vector3::UnitY(), 0});
     },
     "body 'ball' and plane 'floor' may touch, and no material"},
    {"water", [](core::Scene& s) { s.forces.emplace_back(core::Water{}); }, "water has a surface"},
    {"plugin", [](core::Scene& s) { s.forces.emplace_back(core::PluginForce{.bodies = {0}}); },
     "the law of a plug-in is code, and no formula"},
    {"no_body", [](core::Scene& s) { s.bodies.clear(); }, "there is no body"},
    {"locked", [](core::Scene& s) { s.bodies[0].locked = true; }, "no body moves"},
    {"burnt_out",
     [](core::Scene& s) {
       s.forces.emplace_back(core::Thrust{0, {0, 0, 0}, -0.5, core::Vector3(0, -3, 0)});
     },
     "body 'ball' has lost all its mass after 1.4 s"},
    {"mass_of_unknown_velocity",
     [](core::Scene& s) {
       s.forces.emplace_back(core::Thrust{0, {0, 0, 0}, 0.1});
     },
     "at which velocity is not said"},
    {"joint_made_twice",
     [](core::Scene& s) {
       s.joints.push_back({core::JointType::ball, 0, core::world, {0, 1, 0}});
       s.joints.push_back({core::JointType::ball, 0, core::world, {0, 1, 0}});
     },
     "joints depend on each other"},
    {"drag_in_turning_frame",
     [](core::Scene& s) {
       s.forces.emplace_back(core::Drag{0, 0, 0, 0.3});
       s.frame = core::Frame{{0, 0, 0}, {0, 0.4, 0}};
     },
     "not defined in a turning frame"},
    // It falls through the pin of a spring with rest length: |d| = 0 divides.
    {"through_the_pin",
     [](core::Scene& s) {
       s.forces.emplace_back(core::Spring{0, {0, 0, 0}, core::world, {0.2, 1.0, -0.3}, 10, 0.1});
     },
     "cannot be continued beyond"},
};

class Refusals : public testing::TestWithParam<Refusal> {};

TEST_P(Refusals, NameTheReason) {
  core::Scene scene = ball_in_the_air();
  GetParam().change(scene);
  const double times[] = {2.0};
  try {
    certify(scene, times);
    FAIL() << "accepted";
  } catch (const core::OutOfDomain& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().reason), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Refusals, testing::ValuesIn(refusals),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Refusals, TheSceneItselfIsServed) {
  const double times[] = {2.0};
  EXPECT_TRUE(certify(ball_in_the_air(), times).reached);
}

// A radius that the allowed precision cannot give is said, with the best one.
TEST(Refusals, ReportsUnreachableRadius) {
  core::Scene scene = ball_in_the_air();
  scene.forces.emplace_back(core::Spring{0, {0, 0, 0}, core::world, {0, 2, 0}, 10, 0.2});
  const double times[] = {5.0};
  const Certificate found = certify(scene, times, {.radius = 1e-90, .most_bits = 256});
  EXPECT_FALSE(found.reached);
  EXPECT_NE(found.reason.find("was asked for"), std::string::npos);
  EXPECT_TRUE(std::isfinite(found.radius));
}

}  // namespace
}  // namespace cylon::certified
