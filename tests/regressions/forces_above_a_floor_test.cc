// Where spheres might touch something, the default path of the in-house engine dropped thrust, attraction,
// water and changing mass: it listed the forces that closed-form flight does not know, and these were not
// in the list.  A body pushed upwards lay on the floor.  In the stepping path masses never changed.  Now
// each method lists what it supports.
#include "harness/process/client.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cylon::process {
namespace {

constexpr double g = 9.81, duration = 2;

core::Body ball(std::string name, double mass, const core::Vector3& position) {
  core::Body body;
  body.name = std::move(name);
  body.mass = mass;
  body.inertia = core::Matrix3::Identity() * (0.4 * mass * 0.01);
  body.shape = core::Sphere{0.1};
  body.collide = true;
  body.initial.position = position;
  return body;
}

core::Scene above_a_floor(core::Body body) {
  core::Scene scene;
  scene.bodies = {std::move(body)};
  scene.forces = {core::UniformGravity{{0, -g, 0}}};
  scene.planes = {{"floor", core::Vector3::UnitY(), 0}};
  scene.materials = {{{"*", "*"}, 0, 0.5}};
  return scene;
}

core::State end_of(const core::Scene& scene, double dt) {
  RunRequest request;
  request.scene = &scene;
  request.setup.dt = dt;
  request.steps = request.every = std::lround(duration / dt);
  const RunOutcome outcome = run(parse_engine("in-house", default_engines(binary_dir)), request);
  if (!outcome.recording) {
    ADD_FAILURE() << outcome.reason;
    return core::initial_state(scene);
  }
  return outcome.recording->states.back();
}

// p = p_0 + (F/m + g) t^2/2
TEST(ForcesAboveAFloor, ThrustLiftsTheBody) {
  core::Scene scene = above_a_floor(ball("a", 1, {0, 5, 0}));
  scene.forces.emplace_back(core::Thrust{.body = 0, .force = {3, 20, 0}});
  const core::State end = end_of(scene, 0.01);
  EXPECT_NEAR(end[0].position.y(), 5 + (20 - g) * duration * duration / 2, 1e-9);
  EXPECT_NEAR(end[0].position.x(), 3 * duration * duration / 2, 1e-9);
}

// Tsiolkovsky: with m = m_0 - r t and the exhaust at u downwards,
//   y = y_0 - g t^2/2 + u (t - (m_0 - r t)/r ln(m_0/(m_0 - r t)))
double rocket_height(double start, double mass, double rate, double u, double t) {
  const double left = mass - rate * t;
  return start - g * t * t / 2 + u * (t - left / rate * std::log(mass / left));
}

core::Thrust engine_of(int body) {
  return {.body = body, .mass_rate = -1, .exhaust_velocity = core::Vector3(0, -200, 0)};
}

TEST(ForcesAboveAFloor, RocketLiftsOff) {
  core::Scene scene = above_a_floor(ball("rocket", 10, {0, 5, 0}));
  scene.forces.emplace_back(engine_of(0));
  EXPECT_NEAR(end_of(scene, 0.01)[0].position.y(), rocket_height(5, 10, 1, 200, duration), 1e-8);
}

// Two equal masses on a circle about their centre: w^2 = G (m + m)/d^3, and the centre moves on.
TEST(ForcesAboveAFloor, PlanetsThatMayTouchOrbit) {
  core::Scene scene;
  scene.bodies = {ball("a", 1, {0, 0, 0}), ball("b", 1, {1, 0, 0})};
  scene.bodies[1].initial.velocity = {0, 2, 0};
  scene.materials = {{{"*", "*"}, 0, 0.5}};
  scene.forces = {core::Attraction{.body = 0, .to = 1, .strength = 2}};
  const double w = std::sqrt(2.0 * (1 + 1));
  const core::Vector3 centre(0.5, duration, 0);
  const core::Vector3 half = core::Vector3(std::cos(w * duration), std::sin(w * duration), 0) / 2;
  const core::State end = end_of(scene, 0.01);
  EXPECT_LT((end[0].position - (centre - half)).norm(), 1e-8);
  EXPECT_LT((end[1].position - (centre + half)).norm(), 1e-8);
}

// Archimedes: fully submerged, m a = (rho V - m) g.
TEST(ForcesAboveAFloor, WaterLiftsTheBall) {
  core::Scene scene = above_a_floor(ball("cork", 1, {0, 5, 0}));
  scene.forces.emplace_back(core::Water{.level = 100, .buoyancy = 500});
  const double lift = 500 * 4 * std::numbers::pi / 3 * 0.001;
  EXPECT_NEAR(end_of(scene, 0.01)[0].position.y(), 5 + (lift - 1) * g * duration * duration / 2, 1e-8);
}

// Two boxes that something connects are stepped together: second order, so half the step has a quarter of the error.
TEST(ForcesAboveAFloor, RocketLosesMassInTheSteppingPath) {
  core::Scene scene = above_a_floor(ball("rocket", 10, {0, 5, 0}));
  scene.bodies.push_back(ball("other", 1, {5, 0.1, 0}));
  for (core::Body& body : scene.bodies) body.shape = core::Box{{0.1, 0.1, 0.1}};
  scene.forces.emplace_back(engine_of(0));
  core::Spring thread;  // so weak that it only makes them one island
  thread.to = 1, thread.stiffness = 1e-9, thread.rest_length = 7;
  scene.forces.emplace_back(thread);
  const double exact = rocket_height(5, 10, 1, 200, duration);
  const double error = end_of(scene, 0.002)[0].position.y() - exact,
               half = end_of(scene, 0.001)[0].position.y() - exact;
  EXPECT_LT(std::abs(error), 0.05);
  EXPECT_NEAR(half / error, 0.25, 0.01);
}

}  // namespace
}  // namespace cylon::process
