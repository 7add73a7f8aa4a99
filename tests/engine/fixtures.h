// Models with general values (no zeros, no axes), and how far two states are apart.
#pragma once

#include "engine/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cylon::engine {

/// A model and how it starts.
struct Start {
  Model model;
  std::vector<Motion> motion;
};

inline Matrix3 general_inertia(Real a, Real b, Real c) {
  const Matrix3 r = exponential({0.3, -0.7, 0.4}).toRotationMatrix();
  const Matrix3 inertia = r * Vector3(a, b, c).asDiagonal() * r.transpose();
  return (inertia + inertia.transpose()) / 2;
}

inline void add_body(Start& start, const Body& body, const Vector3& position, const Vector3& turn,
                     const Vector3& v, const Vector3& w) {
  start.model.bodies.push_back(body);
  start.motion.push_back(make_motion(body, position, exponential(turn), v, w));
}

/// Two bodies without symmetry and a spring between off-centre anchors; nothing acts from outside.
inline Start coupled_bodies(Real damping = 0) {
  Start start;
  add_body(start, make_body(1.3, general_inertia(0.5, 0.7, 1.0)), {0.4, -0.2, 0.9}, {0.5, 1.1, -0.6},
           {0.3, 0.8, -0.5}, {1.2, -0.7, 0.9});
  add_body(start, make_body(0.8, general_inertia(0.2, 0.35, 0.4)), {-0.9, 0.7, -0.3}, {-1.3, 0.2, 0.8},
           {-0.4, 0.1, 0.6}, {-0.8, 1.5, 0.4});
  start.model.forces.springs.push_back({0, {0.3, -0.1, 0.25}, 1, {-0.15, 0.2, 0.35}, 9.0, 0.7, damping});
  return start;
}

/// The same, damped, pinned to the world, dragged, driven and falling: every force at once.
inline Start forced_bodies() {
  Start start = coupled_bodies(0.4);
  start.model.forces.gravity = {0.3, -9.81, 0.7};
  start.model.forces.springs.push_back({1, {0.2, 0.1, -0.3}, fixed_world, {0.6, 1.9, 0.4}, 25.0, 0.5, 0.6});
  start.model.forces.drags.push_back({0, 0.3, 0.2, 0.1});
  start.model.forces.drives.push_back({0, {0.9, 0.4, -1.1}, 2.3});
  return start;
}

inline Start free_top() {
  Start start;
  add_body(start, make_body(1.5, general_inertia(0.5, 0.7, 1.0)), {1.0, 0.2, 2.0}, {0.4, 1.0, -0.3},
           {0.5, 0.25, -1.0}, {3.0, 1.0, -1.0});
  return start;
}

/// A tilted symmetric top with spin on its tip, the tip at `tip`.
inline Start heavy_top() {
  const Vector3 tip = {0.2, -0.4, 0.3}, anchor = {0, -0.3, 0}, turn = {0.3, 0.2, 0.6};
  const Body body = make_body(1.1, Vector3(0.02, 0.01, 0.02).asDiagonal());
  const Vector3 arm = exponential(turn) * -anchor;
  const Vector3 w = exponential(turn) * Vector3(0.9, 25.0, -0.6);
  Start start;
  add_body(start, body, tip + arm, turn, w.cross(arm), w);
  start.model.forces.gravity = {0, -9.81, 0};
  start.model.joints.push_back({0, anchor, fixed_world, tip});
  return start;
}

/// A sphere at `height` above a plane that is not level, let go with a sideways speed; gravity along the
/// plane's normal.
inline Start ball_over_plane(Real height, Real restitution) {
  const Vector3 normal = Vector3(0.2, 0.9, -0.3).normalized(), along = Vector3(0.9, -0.2, 0).normalized();
  const Real radius = 0.25, offset = 0.4, mass = 0.7;
  Start start;
  add_body(start, make_body(mass, Matrix3::Identity() * (0.4 * mass * radius * radius)),
           (offset + radius + height) * normal, {0.1, 0.2, 0.3}, 0.35 * along, {1.0, 2.0, -0.5});
  start.model.forces.gravity = -9.81 * normal;
  Contact contact;
  contact.radius = radius;
  contact.normal = normal;
  contact.offset = offset;
  contact.restitution = restitution;
  start.model.contacts.push_back(contact);
  return start;
}

/// The world after whole steps of duration / steps.
inline World run(const Start& start, const Integrator& integrator, Real duration, int steps) {
  World running(start.model, start.motion, integrator, duration / steps);
  for (int i = 0; i < steps; ++i) running.step();
  return running;
}

/// 4 asin(|q - q'|/2) after the sign fix [rad].
inline Real angle(const Quaternion& a, const Quaternion& b) {
  const Real d = std::min((a.coeffs() - b.coeffs()).norm(), (a.coeffs() + b.coeffs()).norm());
  return 4 * std::asin(std::min<Real>(1, d / 2));
}

/// The largest difference of the components of two states, SI units mixed.
inline Real distance(const World& a, const World& b) {
  Real worst = 0;
  for (std::size_t i = 0; i < a.motion().size(); ++i) {
    const Motion &x = a.motion()[i], &y = b.motion()[i];
    worst = std::max({worst, (x.position - y.position).norm(), (x.momentum - y.momentum).norm(),
                      (x.angular_momentum - y.angular_momentum).norm(), angle(x.orientation, y.orientation)});
  }
  return worst;
}

inline Vector3 momentum(const std::vector<Motion>& motion) {
  Vector3 sum = Vector3::Zero();
  for (const Motion& m : motion) sum += m.momentum;
  return sum;
}

/// About the world origin: sum p x K + L.
inline Vector3 angular_momentum(const std::vector<Motion>& motion) {
  Vector3 sum = Vector3::Zero();
  for (const Motion& m : motion) sum += m.position.cross(m.momentum) + m.angular_momentum;
  return sum;
}

/// v.K/2 + w.L/2 of all bodies [J].
inline Real kinetic_energy(const std::vector<Body>& bodies, const std::vector<Motion>& motion) {
  Real sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    sum += velocity(bodies[i], motion[i]).dot(motion[i].momentum) / 2 +
           angular_velocity(bodies[i], motion[i]).dot(motion[i].angular_momentum) / 2;
  }
  return sum;
}

/// A readable name for a scheme's test: "velocity_verlet".
inline std::string test_name(std::string_view scheme) {
  std::string name(scheme);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class EveryIntegrator : public testing::TestWithParam<Integrator> {};

}  // namespace cylon::engine

#define CYLON_EVERY_INTEGRATOR(suite)                                                              \
  INSTANTIATE_TEST_SUITE_P(                                                                        \
      Schemes, suite,                                                                              \
      testing::ValuesIn(cylon::engine::integrators().begin(), cylon::engine::integrators().end()), \
      [](const auto& row) { return cylon::engine::test_name(row.param.name); })
