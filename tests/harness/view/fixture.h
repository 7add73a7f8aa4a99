// What the tests of the viewer share: engines as they were built, and small scenes of general values.
#pragma once

#include "harness/process/live.h"
#include "harness/view/session.h"
#include "tests/harness/process/fixture.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cylon::view {

inline const process::Limits limits = {20, 20, std::size_t{2} << 30};

inline std::vector<process::EngineRow> rows() { return process::default_engines(binary_dir); }

inline process::EngineChoice engine(const std::string& id) { return process::parse_engine(id, rows()); }

/// A ball of 2 kg and half a metre over a floor, its lowest point at `height`.
inline core::Scene ball_on_floor(double height, const core::Vector3& velocity, double restitution) {
  core::Scene scene;
  core::Body ball = process::point("ball", {0.3, 0.5 + height, -0.1}, velocity);
  ball.mass = 2;
  ball.inertia = 0.2 * core::Matrix3::Identity();
  ball.shape = core::Sphere{0.5};
  ball.collide = true;
  scene.bodies = {ball};
  scene.forces = {core::UniformGravity{}};
  scene.planes = {{"floor", core::Vector3::UnitY(), 0}};
  scene.materials = {{{"*", "*"}, restitution, 0.3}};
  return scene;
}

/// A double pendulum of two turned boxes on hinges that are not parallel to any axis, swinging.
inline core::Scene hinged_pair() {
  core::Scene scene;
  const core::Vector3 axis = core::Vector3(0.3, -0.2, 1).normalized();
  const core::Quaternion turn(Eigen::AngleAxisd(0.7, core::Vector3(1, 2, -1).normalized()));
  const core::Vector3 pivot(0.1, 0.2, 0.3), spin = 1.3 * axis, more = -0.4 * axis;
  core::Body upper = process::point("upper", {0.5, -0.3, 0.35}, {0, 0, 0}),
             lower = process::point("lower", {1.1, -0.9, 0.2}, {0, 0, 0});
  upper.inertia = core::Vector3(0.1, 0.2, 0.25).asDiagonal();
  lower.inertia = core::Vector3(0.3, 0.12, 0.2).asDiagonal();
  upper.mass = 1.3, lower.mass = 0.7;
  upper.initial.orientation = turn, lower.initial.orientation = turn.conjugate();
  const core::Vector3 elbow(0.8, -0.6, 0.3);
  upper.initial.angular_velocity = spin, lower.initial.angular_velocity = spin + more;
  upper.initial.velocity = spin.cross(upper.initial.position - pivot);
  lower.initial.velocity = spin.cross(elbow - pivot) + (spin + more).cross(lower.initial.position - elbow);
  scene.bodies = {upper, lower};
  scene.forces = {core::UniformGravity{}};
  scene.joints = {{core::JointType::hinge, 0, core::world, pivot, axis, 0},
                  {core::JointType::hinge, 1, 0, elbow, axis, 0}};
  return scene;
}

inline core::Setup setup(double dt, const std::string& integrator = "") {
  core::Setup result;
  result.dt = dt;
  result.integrator = integrator;
  return result;
}

/// A scenario around a scene, without claims.
inline scenario::Scenario scenario(core::Scene scene) {
  scenario::Scenario result;
  result.name = "test";
  result.title = "Test";
  result.story = "A scene of the tests.";
  result.duration = 1;
  result.step = 0.01;
  result.step_text = "0.01";
  result.scene = std::move(scene);
  return result;
}

inline SessionOptions options(const std::string& id, const std::string& integrator = "",
                              const std::string& dt = "0.01") {
  SessionOptions result;
  result.rows = rows();
  result.lane = {id, integrator, dt};
  result.limits = limits;
  return result;
}

/// Lets simulated time pass until it is t, whatever that takes.
inline void advance_to(Session& session, double t) {
  for (int i = 0; i < 10000 && session.time() < t - 1e-9; ++i)
    session.advance((t - session.time()) / session.speed());
}

inline core::Vector3 momentum(const core::Scene& scene, const core::State& state) {
  core::Vector3 sum = core::Vector3::Zero();
  for (std::size_t i = 0; i < state.size(); ++i) sum += scene.bodies[i].mass * state[i].velocity;
  return sum;
}

}  // namespace cylon::view
