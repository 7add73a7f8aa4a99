// Each reason for which Siconos refuses a scene, and the scene beside it that it takes.
#include "reference/simulators/siconos/siconos_limits.h"

#include "harness/core/simulator.h"

#include <gtest/gtest.h>

#include <functional>

namespace cylon::simulators {
namespace {

using core::Scene;
using core::Vector3;

// Two spheres that may touch each other and a plane, and a third body; nothing that Siconos refuses.
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
  return one;
}

struct Refusal {
  const char* reason;
  std::function<void(Scene&)> refused, taken;
};

const Refusal refusals[] = {
    {"Siconos needs a mass above zero of what moves; 'b' has 0 kg.", [](Scene& s) { s.bodies[1].mass = 0; },
     [](Scene& s) { s.bodies[1].mass = 0, s.bodies[1].locked = true; }},
    {"Siconos needs principal moments above zero of what moves; 'c' has one of 0 kg m^2.",
     [](Scene& s) { s.bodies[2].inertia(1, 1) = 0; },
     [](Scene& s) { s.bodies[2].inertia(1, 1) = 0, s.bodies[2].locked = true; }},
    {"Siconos has joints in its library of mechanics alone, which this adapter leaves out; 'c' has one of "
     "type "
     "ball.",
     [](Scene& s) { s.joints = {joint(core::JointType::ball, 2, 0)}; },
     [](Scene& s) {
       s.joints = {joint(core::JointType::ball, 2, 0)};
       s.bodies[0].locked = s.bodies[2].locked = true;
     }},
    {"'a' may touch 'b', but the scene has no material for them.",
     [](Scene& s) {
       s.materials = {{{"*", "floor"}, 0.4, 0.3}};
     },
     [](Scene& s) {
       s.materials = {{{"*", "floor"}, 0.4, 0.3}, {{"a", "b"}, 0, 0}};
     }},
    {"Body 'b': the kernel of Siconos has no shapes; this adapter gives it the distances of spheres and "
     "planes "
     "alone.",
     [](Scene& s) {
       s.bodies[1].shape = core::Box{{0.1, 0.2, 0.3}};
     },
     [](Scene& s) {
       s.bodies[1].shape = core::Box{{0.1, 0.2, 0.3}}, s.bodies[1].collide = false;
     }},
    {"Body 'c' in water: a rod has no volume.",
     [](Scene& s) {
       s.forces.emplace_back(core::Water{.level = 1, .buoyancy = 1000});
       s.bodies[2].shape = core::Rod{0.3};
     },
     [](Scene& s) { s.bodies[2].shape = core::Rod{0.3}; }},
};

TEST(SiconosLimits, AreEachASentenceAndNoWider) {
  EXPECT_FALSE(siconos_limit(taken()));
  for (const Refusal& refusal : refusals) {
    Scene scene = taken();
    refusal.refused(scene);
    const auto reason = siconos_limit(scene);
    ASSERT_TRUE(reason) << refusal.reason;
    EXPECT_NE(reason->find(refusal.reason), std::string::npos) << *reason;
    Scene other = taken();
    refusal.taken(other);
    const auto none = siconos_limit(other);
    EXPECT_FALSE(none) << refusal.reason << "\n" << *none;
  }
}

TEST(SiconosLimits, NeedAStepForward) {
  const auto simulator = core::make_simulator();
  EXPECT_EQ(simulator->unsupported(taken(), {.dt = 0}), "Siconos steps forward only; dt = 0 s.");
  EXPECT_FALSE(simulator->unsupported(taken(), {.dt = 1e-3}));
}

}  // namespace
}  // namespace cylon::simulators
