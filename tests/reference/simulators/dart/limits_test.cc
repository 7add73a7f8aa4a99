// Each reason for which DART refuses a scene, and the scene beside it that it takes.
#include "reference/simulators/dart/dart_limits.h"

#include "harness/core/simulator.h"

#include <gtest/gtest.h>

#include <functional>

namespace cylon::simulators {
namespace {

using core::Scene;
using core::Vector3;

// Two spheres that may touch each other and a plane, and a third body; nothing that DART refuses.
Scene taken() {
  Scene scene;
  scene.bodies.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    scene.bodies[i].name = std::string(1, static_cast<char>('a' + i));
    scene.bodies[i].inertia = Vector3(0.2, 0.3, 0.4).asDiagonal();
    scene.bodies[i].initial.position = {0.3 * static_cast<double>(i), 2, -0.1};
  }
  for (std::size_t i = 0; i < 2; ++i)
    scene.bodies[i].shape = core::Sphere{0.1}, scene.bodies[i].collide = true;
  scene.planes = {{"floor", Vector3::UnitY(), 0, {}, {}}};
  scene.materials = {{{"*", "*"}, 0.4, 0.3}};
  return scene;
}

core::Joint joint(core::JointType type, int body, int to) {
  core::Joint one{.type = type, .body = body, .to = to, .point = {0.1, 0.2, 0.3}};
  one.length = 0.3;
  return one;
}

struct Refusal {
  const char* reason;
  std::function<void(Scene&)> refused, taken;
};

const Refusal refusals[] = {
    {"DART needs a mass above zero of what moves; 'b' has 0 kg.", [](Scene& s) { s.bodies[1].mass = 0; },
     [](Scene& s) { s.bodies[1].mass = 0, s.bodies[1].locked = true; }},
    {"DART needs principal moments above zero of what moves; 'c' has one of 0 kg m^2.",
     [](Scene& s) { s.bodies[2].inertia(1, 1) = 0; },
     [](Scene& s) { s.bodies[2].inertia(1, 1) = 0, s.bodies[2].locked = true; }},
    {"DART has no constraint that keeps a distance, such as that of 'c'",
     [](Scene& s) { s.joints = {joint(core::JointType::distance, 2, 0)}; },
     [](Scene& s) {
       s.joints = {joint(core::JointType::distance, 2, 0)};
       s.bodies[0].locked = s.bodies[2].locked = true;
     }},
    {"This adapter gives DART no joint of type slider, such as that of 'c'.",
     [](Scene& s) { s.joints = {joint(core::JointType::slider, 2, core::world)}; },
     [](Scene& s) { s.joints = {joint(core::JointType::fixed, 2, core::world)}; }},
    {"The hinge of 'c' closes a loop, for which DART has a ball and a weld alone",
     [](Scene& s) {
       s.joints = {joint(core::JointType::hinge, 2, core::world),
                   joint(core::JointType::hinge, 2, core::world)};
     },
     [](Scene& s) {
       s.joints = {joint(core::JointType::hinge, 2, core::world),
                   joint(core::JointType::ball, 2, core::world)};
     }},
    {"'a' may touch 'b', but the scene has no material for them.",
     [](Scene& s) {
       s.materials = {{{"*", "floor"}, 0.4, 0.3}};
     },
     [](Scene& s) {
       s.materials = {{{"*", "floor"}, 0.4, 0.3}, {{"a", "b"}, 0, 0}};
     }},
    {"Body 'b': DART's own detector collides spheres and boxes alone",
     [](Scene& s) {
       s.bodies[1].shape = core::Cylinder{0.1, 0.3};
     },
     [](Scene& s) {
       s.bodies[1].shape = core::Cylinder{0.1, 0.3}, s.bodies[1].collide = false;
     }},
    {"DART takes a restitution of at most 0.001 for none",
     [](Scene& s) { s.materials[0].restitution = 1e-3; },
     [](Scene& s) { s.materials[0].restitution = 1.1e-3; }},
    {"DART takes a friction of at most 0.001 for none", [](Scene& s) { s.materials[0].friction = 1e-3; },
     [](Scene& s) { s.materials[0].friction = 0; }},
    {"DART has no contact of two spheres whose centres are within 0.001 m "
     "(collision/dart/DARTCollide.cpp:1342), which is all of a contact of 'a' and 'b'.",
     [](Scene& s) { s.bodies[0].shape = core::Sphere{6e-4}, s.bodies[1].shape = core::Sphere{3e-4}; },
     [](Scene& s) { s.bodies[0].shape = core::Sphere{6e-4}, s.bodies[1].shape = core::Sphere{5e-4}; }},
    {"Body 'c' in water: a rod has no volume.",
     [](Scene& s) {
       s.forces.emplace_back(core::Water{.level = 1, .buoyancy = 1000});
       s.bodies[2].shape = core::Rod{0.3};
     },
     [](Scene& s) { s.bodies[2].shape = core::Rod{0.3}; }},
};

TEST(DartLimits, AreEachASentenceAndNoWider) {
  EXPECT_FALSE(dart_limit(taken()));
  for (const Refusal& refusal : refusals) {
    Scene scene = taken();
    refusal.refused(scene);
    const auto reason = dart_limit(scene);
    ASSERT_TRUE(reason) << refusal.reason;
    EXPECT_NE(reason->find(refusal.reason), std::string::npos) << *reason;
    Scene other = taken();
    refusal.taken(other);
    const auto none = dart_limit(other);
    EXPECT_FALSE(none) << refusal.reason << "\n" << *none;
  }
}

TEST(DartLimits, NeedAStepForward) {
  const auto simulator = core::make_simulator();
  EXPECT_EQ(simulator->unsupported(taken(), {.dt = 0}), "DART steps forward only; dt = 0 s.");
  EXPECT_FALSE(simulator->unsupported(taken(), {.dt = 1e-3}));
}

}  // namespace
}  // namespace cylon::simulators
