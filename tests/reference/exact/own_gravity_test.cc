// A gravity that all bodies state is the same as the scene's, whatever that is; one that differs is used for its body
// alone, or the scene is refused.
#include "reference/exact/catalogue.h"
#include "tests/reference/exact/contact_scenes.h"
#include "tests/reference/exact/reference_file.h"
#include "tests/reference/exact/smooth_scenes.h"

#include <gtest/gtest.h>

namespace cylon::exact {
namespace {

using core::Scene;

// A scene inside the domain of each solution that reads gravity.
std::vector<std::pair<std::string, Scene>> scenes() {
  std::vector<std::pair<std::string, Scene>> all;
  for (const Solution& solution : catalogue()) {
    const std::string name(solution.name);
    if (name == "bouncing_sphere" || name == "two_sphere_oblique")
      all.emplace_back(name, ReferenceFile(name).scene);
    else if (name == "sphere_row" || name == "sliding_block" || name == "rough_sphere")
      all.emplace_back(name, ContactScenes(5).scene(name));
    else if (name == "rotating_frame" || name == "water_step_force" || name == "spring_orbit")
      continue;  // gravity has no part in the first and the last, and is vertical in the second
    else if (SmoothScenes::knows(name))
      all.emplace_back(name, SmoothScenes(5).scene(name));
    else if (RandomScenes::knows(name))
      all.emplace_back(name, RandomScenes(5).scene(name));
  }
  return all;
}

core::Truth make(std::string_view name, const Scene& scene) {
  for (const Solution& solution : catalogue())
    if (solution.name == name) return solution.make(scene, 1);
  throw std::runtime_error("no solution " + std::string(name));
}

// The same motion, with another gravity in the scene that acts on nobody.
Scene stated_by_bodies(const Scene& scene) {
  Scene own = scene;
  for (core::Body& body : own.bodies)
    if (!body.locked) body.gravity = core::gravity(scene);
  std::erase_if(own.forces,
                [](const core::Force& f) { return std::holds_alternative<core::UniformGravity>(f); });
  own.forces.emplace_back(core::UniformGravity{{1.3, 2.1, -0.7}});
  return own;
}

TEST(OwnGravity, OfAllIsTheScenes) {
  int tried = 0;
  for (const auto& [name, scene] : scenes()) {
    SCOPED_TRACE(name);
    const core::Truth plain = make(name, scene), own = make(name, stated_by_bodies(scene));
    for (const double t : {0., 0.31, 0.77, 1.}) {
      const core::State a = plain.state(t), b = own.state(t);
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].position, b[i].position);
        EXPECT_EQ(a[i].velocity, b[i].velocity);
        EXPECT_EQ(a[i].orientation.coeffs(), b[i].orientation.coeffs());
        EXPECT_EQ(a[i].angular_velocity, b[i].angular_velocity);
      }
    }
    ++tried;
  }
  EXPECT_GT(tried, 20);
}

// The first body falls another way: its own motion is then that of a scene in which all do, or there is none.
TEST(OwnGravity, OfOneIsUsedOrRefused) {
  int used = 0, refused = 0;
  for (const auto& [name, scene] : scenes()) {
    SCOPED_TRACE(name);
    const core::Vector3 other = 0.8 * core::gravity(scene) + core::Vector3(0, -0.1, 0);
    Scene one = scene, all = scene;
    one.bodies[0].gravity = other;
    for (core::Body& body : all.bodies) body.gravity = other;
    try {
      const core::Truth truth = make(name, one);
      const core::State a = truth.state(0.9), alone = make(name, all).state(0.9),
                        plain = make(name, scene).state(0.9);
      EXPECT_EQ(a[0].position, alone[0].position);
      for (std::size_t i = 1; i < a.size(); ++i) EXPECT_EQ(a[i].position, plain[i].position);
      ++used;
    } catch (const core::OutOfDomain&) {
      ++refused;
    }
  }
  EXPECT_GT(used, 10);
  EXPECT_GT(refused, 0);
}

TEST(OwnGravity, IsRefusedWhereGravityIsNotKnown) {
  Scene scene = SmoothScenes::knows("rotating_frame") ? SmoothScenes(5).scene("rotating_frame")
                                                      : RandomScenes(5).scene("rotating_frame");
  EXPECT_NO_THROW(make("rotating_frame", scene));
  scene.bodies[0].gravity = core::Vector3::Zero();
  EXPECT_NO_THROW(make("rotating_frame", scene));
  scene.bodies[0].gravity = core::Vector3(0, 0, 1e-3);
  EXPECT_THROW(make("rotating_frame", scene), core::OutOfDomain);
}

}  // namespace
}  // namespace cylon::exact
