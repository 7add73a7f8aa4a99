// Reasons for which an adapter refuses a scene, each with the scene beside it that it takes.
#pragma once

#include "harness/core/simulator.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <span>
#include <string>

namespace cylon::simulators {

using core::Scene;
using core::Vector3;

/// Two spheres that may touch each other and a plane, and a third body: nothing that any of these adapters refuses.
inline Scene taken() {
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

inline core::Joint joint(core::JointType type, int body, int to) {
  core::Joint one{.type = type, .body = body, .to = to, .point = {0.1, 0.2, 0.3}};
  one.length = 0.3;
  return one;
}

/// Changes of taken().
struct Refusal {
  const char* reason;
  std::function<void(Scene&)> refused, taken;
};

/// Each is refused by `limit` for its reason, and the scene beside it is not.
template <class Limit>
void expect_each(Limit limit, std::span<const Refusal> refusals) {
  EXPECT_FALSE(limit(taken()));
  for (const Refusal& refusal : refusals) {
    Scene scene = taken();
    refusal.refused(scene);
    const auto reason = limit(scene);
    ASSERT_TRUE(reason) << refusal.reason;
    EXPECT_NE(reason->find(refusal.reason), std::string::npos) << *reason;
    Scene other = taken();
    refusal.taken(other);
    const auto none = limit(other);
    EXPECT_FALSE(none) << refusal.reason << "\n" << *none;
  }
}

inline void expect_a_step_forward(const char* engine) {
  const auto simulator = core::make_simulator();
  EXPECT_EQ(simulator->unsupported(taken(), {.dt = 0}),
            fmt::format("{} steps forward only; dt = 0 s.", engine));
  EXPECT_FALSE(simulator->unsupported(taken(), {.dt = 1e-3}));
}

}  // namespace cylon::simulators
