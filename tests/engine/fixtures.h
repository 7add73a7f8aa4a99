// Models with general values (no zeros, no axes), how they are run, and how far two motions are apart.
#pragma once

#include "engine/integrators/integrator.h"
#include "engine/world.h"
#include "tests/engine/joint_types.h"
#include "tests/engine/momenta.h"
#include "tests/engine/same_bits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::engine {

inline Matrix3 general_inertia(Real a, Real b, Real c) {
  const Matrix3 r = exponential({0.3, -0.7, 0.4}).toRotationMatrix();
  const Matrix3 inertia = r * Vector3(a, b, c).asDiagonal() * r.transpose();
  return (inertia + inertia.transpose()) / 2;
}

inline void add_body(Model& model, const Body& body, const Vector3& position, const Vector3& turn,
                     const Vector3& v, const Vector3& w, const Shape& shape = {}) {
  model.bodies.push_back(body);
  model.motions.push_back(make_motion(body, position, exponential(turn), v, w));
  model.shapes.push_back(shape);
  model.surfaces.push_back(no_surface);
}

/// Gives all bodies with a shape, and all planes, the one surface.
inline void make_touchable(Model& model, Real restitution, Real friction = 0) {
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    model.surfaces[i] = std::holds_alternative<std::monostate>(model.shapes[i]) ? no_surface : 0;
  }
  model.plane_surfaces.assign(model.planes.size(), 0);
  model.surface_count = 1;
  model.materials = {{restitution, friction}};
}

/// Two bodies without symmetry and a spring between off-centre anchors; nothing acts from outside.
inline Model coupled_bodies(Real damping = 0) {
  Model model;
  add_body(model, make_body(1.3, general_inertia(0.5, 0.7, 1.0)), {0.4, -0.2, 0.9}, {0.5, 1.1, -0.6},
           {0.3, 0.8, -0.5}, {1.2, -0.7, 0.9});
  add_body(model, make_body(0.8, general_inertia(0.2, 0.35, 0.4)), {-0.9, 0.7, -0.3}, {-1.3, 0.2, 0.8},
           {-0.4, 0.1, 0.6}, {-0.8, 1.5, 0.4});
  model.forces.springs.push_back({0, {0.3, -0.1, 0.25}, 1, {-0.15, 0.2, 0.35}, 9.0, 0.7, damping});
  return model;
}

/// The same, damped, tied to the world, dragged, driven and falling: forces that read time, place, turn and
/// speed at once.
inline Model forced_bodies() {
  Model model = coupled_bodies(0.4);
  model.forces.gravity = {0.3, -9.81, 0.7};
  model.forces.springs.push_back({1, {0.2, 0.1, -0.3}, fixed_world, {0.6, 1.9, 0.4}, 25.0, 0.5, 0.6});
  model.forces.drags.push_back({0, 0.3, 0.2, 0.1});
  model.forces.drives.push_back({0, {0.9, 0.4, -1.1}, 2.3});
  return model;
}

inline Model free_top() {
  Model model;
  add_body(model, make_body(1.5, general_inertia(0.5, 0.7, 1.0)), {1.0, 0.2, 2.0}, {0.4, 1.0, -0.3},
           {0.5, 0.25, -1.0}, {3.0, 1.0, -1.0});
  return model;
}

/// A tilted symmetric top with spin on its tip, the tip at a general place.
inline Model heavy_top() {
  const Vector3 tip = {0.2, -0.4, 0.3}, anchor = {0, -0.3, 0}, turn = {0.3, 0.2, 0.6};
  const Body body = make_body(1.1, Vector3(0.02, 0.01, 0.02).asDiagonal());
  const Vector3 arm = exponential(turn) * -anchor;
  const Vector3 w = exponential(turn) * Vector3(0.9, 25.0, -0.6);
  Model model;
  add_body(model, body, tip + arm, turn, w.cross(arm), w);
  model.forces.gravity = {0, -9.81, 0};
  model.joints.push_back({.body = 0, .anchor = anchor, .to_anchor = tip});
  return model;
}

/// Two bodies without symmetry on a ball joint between them; the first one hangs on the world where `pinned`.
inline Model linked_bodies(bool pinned) {
  Model model;
  const Vector3 a0 = {0.3, -0.2, 0.1}, a1 = {-0.4, 0.1, 0.2}, b0 = {0.2, 0.3, -0.1};
  const Body first = make_body(1.3, general_inertia(0.05, 0.07, 0.1));
  const Body second = make_body(0.8, general_inertia(0.02, 0.035, 0.04));
  const Vector3 turn_a = {0.5, 1.1, -0.6}, turn_b = {-1.3, 0.2, 0.8};
  const Vector3 w_a = {1.2, -0.7, 0.9}, w_b = {-0.8, 1.5, 0.4}, pivot = {0.1, 0.2, 0.3};
  const Vector3 p_a = pivot - exponential(turn_a) * a0;
  const Vector3 v_a = pinned ? Vector3(w_a.cross(p_a - pivot)) : Vector3(0.3, 0.8, -0.5);
  const Vector3 r_a = exponential(turn_a) * a1, r_b = exponential(turn_b) * b0;
  add_body(model, first, p_a, turn_a, v_a, w_a);
  add_body(model, second, p_a + r_a - r_b, turn_b, v_a + w_a.cross(r_a) - w_b.cross(r_b), w_b);
  model.joints.push_back({.body = 0, .anchor = a1, .to = 1, .to_anchor = b0});
  if (pinned) {
    model.joints.push_back({.body = 0, .anchor = a0, .to_anchor = pivot});
    model.forces.gravity = {0, -9.81, 0};
  }
  return model;
}

/// A sphere at `height` above a plane that is not level, let go with a sideways speed; gravity along the
/// plane's normal.
inline Model ball_over_plane(Real height, Real restitution) {
  const Vector3 normal = Vector3(0.2, 0.9, -0.3).normalized(), along = Vector3(0.9, -0.2, 0).normalized();
  const Real radius = 0.25, offset = 0.4, mass = 0.7;
  Model model;
  add_body(model, make_body(mass, Matrix3::Identity() * (0.4 * mass * radius * radius)),
           (offset + radius + height) * normal, {0.1, 0.2, 0.3}, 0.35 * along, {1.0, 2.0, -0.5},
           Sphere{radius});
  model.forces.gravity = -9.81 * normal;
  model.planes.push_back({normal, offset});
  make_touchable(model, restitution);
  return model;
}

/// How far the sphere of `body` is from a plane [m].
inline Real plane_gap(const Model& model, const std::vector<Motion>& motions, std::size_t body = 0,
                      std::size_t plane = 0) {
  const Plane& p = model.planes[plane];
  return p.normal.dot(motions[body].position) - p.offset - std::get<Sphere>(model.shapes[body]).radius;
}

/// What a run leaves.
struct Outcome {
  std::vector<Body> bodies;
  std::vector<Motion> motions;
  std::vector<Impact> impacts;  ///< Of all steps.
  std::vector<Real> works;
  std::vector<std::string> remarks;
};

/// After whole steps of options.dt; `watch(world)` is called after each.
template <class Watch>
Outcome run(const Model& model, const Options& options, int steps, Watch watch) {
  EXPECT_EQ(unsupported(model, options), "");
  World world(model, options);
  Outcome all;
  for (int i = 0; i < steps; ++i) {
    world.step();
    all.impacts.insert(all.impacts.end(), world.impacts().begin(), world.impacts().end());
    watch(world);
  }
  all.bodies = world.bodies();
  all.motions = world.motions();
  all.remarks = world.remarks();
  if (world.works()) all.works.assign(world.works(), world.works() + model.forces.count());
  return all;
}

inline Outcome run(const Model& model, const Options& options, int steps) {
  return run(model, options, steps, [](const World&) {});
}

inline Options with(std::string_view integrator, Time dt) {
  return {.integrator = std::string(integrator), .dt = dt};
}

/// After whole steps of duration / steps.
inline Outcome run(const Model& model, std::string_view integrator, Time duration, int steps) {
  return run(model, with(integrator, duration / steps), steps);
}

/// 4 asin(|q - q'|/2) after the sign fix [rad].
inline Real angle(const Quaternion& a, const Quaternion& b) {
  const Real d = std::min((a.coeffs() - b.coeffs()).norm(), (a.coeffs() + b.coeffs()).norm());
  return 4 * std::asin(std::min<Real>(1, d / 2));
}

/// The largest difference of the components of two motions, SI units mixed.
inline Real distance(const std::vector<Motion>& a, const std::vector<Motion>& b) {
  Real worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Motion &x = a[i], &y = b[i];
    worst = std::max({worst, (x.position - y.position).norm(), (x.momentum - y.momentum).norm(),
                      (x.angular_momentum - y.angular_momentum).norm(), angle(x.orientation, y.orientation)});
    if (!std::isfinite(worst)) return std::numeric_limits<Real>::infinity();
  }
  return worst;
}

/// v.K/2 + w.L/2 of all bodies [J]; seed eq. 84 with the tensor (errata 23).
inline Real kinetic_energy(const std::vector<Body>& bodies, const std::vector<Motion>& motions) {
  Real sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    sum += velocity(bodies[i], motions[i]).dot(motions[i].momentum) / 2 +
           angular_velocity(bodies[i], motions[i]).dot(motions[i].angular_momentum) / 2;
  }
  return sum;
}

/// Where the end of a spring or a joint is.
inline Vector3 place(const std::vector<Motion>& motions, int body, const Vector3& anchor) {
  if (body == fixed_world) return anchor;
  const Motion& m = motions[static_cast<std::size_t>(body)];
  return m.position + m.orientation * anchor;
}

/// Of gravity and springs [J].
inline Real potential_energy(const Model& model, const std::vector<Motion>& motions) {
  Real sum = 0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    sum -= model.bodies[i].mass * model.forces.gravity.dot(motions[i].position);
  }
  for (const Spring& s : model.forces.springs) {
    const Real stretch =
        (place(motions, s.body, s.anchor) - place(motions, s.to, s.to_anchor)).norm() - s.rest_length;
    sum += s.stiffness / 2 * stretch * stretch;
  }
  return sum;
}

inline Real energy(const Model& model, const std::vector<Motion>& motions) {
  return kinetic_energy(model.bodies, motions) + potential_energy(model, motions);
}

inline Real angle_between(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// How far a joint is from closed: the distance of its anchors, of a hinge also the angle of its axes, of a
/// fixed one the angle between the bodies.  SI units mixed.
inline Real joint_gap(const std::vector<Motion>& motions, const Joint& joint) {
  const Vector3 d = place(motions, joint.body, joint.anchor) - place(motions, joint.to, joint.to_anchor);
  if (joint.type == joint_types::distance) return std::abs(d.norm() - joint.length);
  const auto turn = [&](int body) -> Quaternion {
    if (body == fixed_world) return Quaternion::Identity();
    return motions[static_cast<std::size_t>(body)].orientation;
  };
  Real gap = d.norm();
  if (joint.type == joint_types::hinge) {
    gap = std::max(gap, angle_between(turn(joint.body) * joint.axis, turn(joint.to) * joint.to_axis));
  } else if (joint.type == joint_types::fixed) {
    gap = std::max(gap, angle(turn(joint.body), turn(joint.to) * joint.relative));
  }
  return gap;
}

/// All rows that step by dt, without those that choose their own steps.
inline std::vector<Integrator> fixed_integrators() {
  std::vector<Integrator> rows;
  for (const Integrator& row : integrators()) {
    if (row.kind != Kind::adaptive) rows.push_back(row);
  }
  return rows;
}

inline void PrintTo(const Integrator& integrator, std::ostream* out) { *out << integrator.name; }

/// A readable name for an integrator's test: "velocity_verlet".
inline std::string test_name(std::string_view integrator) {
  std::string name(integrator);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class EveryIntegrator : public testing::TestWithParam<Integrator> {};

}  // namespace cylon::engine

#define CYLON_EVERY_SCHEME(suite)                                                                     \
  INSTANTIATE_TEST_SUITE_P(Integrators, suite, testing::ValuesIn(cylon::engine::fixed_integrators()), \
                           [](const auto& row) { return cylon::engine::test_name(row.param.name); })
