// Scenes in which the in-house engine cannot keep what was asked, each in one way.
#pragma once

#include "engine/geometry/hull.h"
#include "tests/engine/contact/contact_fixtures.h"
#include "tests/engine/fixtures.h"

#include <cmath>
#include <random>
#include <vector>

namespace cylon::engine {

inline Options on(const char* path, Time dt, Real tolerance = 0) {
  Options options = with("auto", dt);
  options.path = path, options.tolerance = tolerance;
  return options;
}

inline Model floor(const Material& material) { return with_plane(Vector3::UnitY(), 0, material); }

inline void box(Model& model, const Vector3& p, const Vector3& v = Vector3::Zero(), Real half = Real(0.5)) {
  add_box(model, 1, Vector3::Constant(half), p, Quaternion::Identity(), v, Vector3::Zero());
}

inline void ball(Model& model, const Vector3& p, const Vector3& v = Vector3::Zero(), Real mass = 1) {
  add_sphere(model, mass, Real(0.5), p, v, Vector3::Zero());
}

// A point on a rod of 1.3 m, as a constraint.
inline Model on_rod(Real speed) {
  Model model;
  add_body(model, make_body(2, Matrix3::Identity() / 10), {0.5, -1.2, 0}, {0, 0, 0},
           speed * Vector3(1.2, 0.5, 0) / 1.3, {0, 0, 0});
  model.forces.gravity = {0, Real(-9.81), 0};
  Joint joint;
  joint.type.place = Joint::Place::at_length;
  joint.length = Real(1.3);
  model.joints.push_back(joint);
  model.reduce_joints = false;
  return model;
}

// A beam on two links of a ten-millionth of its mass: a four-bar, over a dead point.
inline Model light_links() {
  Model model;
  model.forces.gravity = {0, Real(-9.81), 0};
  const Matrix3 beam = Vector3(Real(0.1), Real(0.12), Real(0.15)).asDiagonal(), link = Real(1e-7) * beam;
  for (const Vector3& at : {Vector3(0.5, 0, 0), Vector3(1.5, 0.5, 0), Vector3(2, 0.5, 0)}) {
    const bool light = at.x() != Real(1.5);
    add_body(model, make_body(light ? Real(1e-7) : Real(1), light ? link : beam), at, {0, 0, 0}, {0, 0, 0},
             {0, 0, 0});
  }
  const auto hinge = [&](int body, int to, const Vector3& point) {
    const auto arm = [&](int end) -> Vector3 {
      return end == fixed_world ? point : point - model.motions[static_cast<std::size_t>(end)].position;
    };
    model.joints.push_back({.type = joint_types::hinge,
                            .body = body,
                            .anchor = arm(body),
                            .to = to,
                            .to_anchor = arm(to),
                            .axis = Vector3::UnitZ(),
                            .to_axis = Vector3::UnitZ()});
  };
  hinge(0, fixed_world, {0, 0, 0});
  hinge(1, 0, {1, 0, 0});
  hinge(2, 1, {2, 1, 0});
  hinge(2, fixed_world, {2, 0, 0});
  return model;
}

// Two points of 1 kg that fall on each other from rest, 2 m apart, at strength 1: in pi/2 sqrt(2) s, Kepler's third law.
inline constexpr double meet_at = 2.2214414690791831;

inline Model falling_together() {
  Model model;
  for (const Real x : {Real(-1), Real(1)})
    add_body(model, make_body(1, Matrix3::Zero()), {x, 0.3, -0.2}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  model.forces.attractions.push_back({0, 1, 1});
  return model;
}

// The seed's water: below the surface a lift that is twice the weight.  From `height` above, at rest.
inline Model at_the_surface(Real height) {
  Model model;
  model.forces.gravity = {0, Real(-9.81), 0};
  add_body(model, make_body(1, Matrix3::Identity() / 10), {0, 2 + height, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0},
           Sphere{Real(0.5)});
  Water water;
  water.level = 2, water.buoyancy = 20, water.drag = 30;
  water.mode = WaterMode::step;
  model.forces.waters.push_back(water);
  return model;
}

inline Model sliding_capsules() {
  Model model = without_plane({0, 0});
  model.forces.gravity = {0, Real(-9.81), 0};
  const Quaternion lies(Eigen::AngleAxis<Real>(Real(M_PI / 2), Vector3::UnitX()));
  for (const bool locked : {true, false}) {
    const Body body = make_body(1, Matrix3::Identity() / 20, locked);
    add(model, body, Capsule{Real(0.2), Real(0.5)},
        make_motion(body, {0, locked ? Real(0) : Real(0.4), 0}, lies, {0, 0, locked ? Real(0) : Real(0.2)},
                    Vector3::Zero()));
  }
  return model;
}

// A leaning rod that slides and digs itself in.
inline Model jamming_rod() {
  Model model = floor({0, 5});
  const Vector3 half(0.001, 1, 0.001);
  const Quaternion q = exponential(Vector3(0, 0, -1));
  const Real low = (q * Vector3(half.x(), -half.y(), half.z())).y();
  add_box(model, 1, half, Vector3(0, -low, 0), q, {-3, 0, 0}, Vector3::Zero());
  return model;
}

inline Model row_of_balls(int count) {
  Model model = without_plane({1, 0});
  for (int i = 0; i < count; ++i) ball(model, {static_cast<Real>(i), 0, 0});
  ball(model, {static_cast<Real>(count) + Real(0.001), 0, 0}, {-1, 0, 0});
  return model;
}

inline Model prism(int sides, const Vector3& p) {
  std::vector<Vector3> points;
  for (const Real y : {Real(-0.5), Real(0.5)})
    for (int k = 0; k < sides; ++k) {
      const Real angle = 2 * Real(M_PI) * static_cast<Real>(k) / static_cast<Real>(sides);
      points.emplace_back(std::cos(angle), y, std::sin(angle));
    }
  Model model = floor({0, Real(0.3)});
  const Body body = make_body(1, Matrix3::Identity() / 3);
  add(model, body, make_hull(points),
      make_motion(body, p, Quaternion::Identity(), Vector3::Zero(), Vector3::Zero()));
  return model;
}

// A rod of square section thrown at a rough floor in the plane, and a little out of it; `seed` says how.
inline Model thrown_rod(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](Real low, Real high) {
    return low + (high - low) * static_cast<Real>(static_cast<double>(random()) / 4294967296.0);
  };
  Model model = floor({0, between(Real(1.2), 8)});
  const Real width = seed % 2 ? Real(0.001) : between(Real(0.001), Real(0.2));
  const Quaternion q = exponential(Vector3(0, 0, -between(Real(0.1), Real(1.5))));
  Real low = 0;
  for (const Real x : {-width, width})
    for (const Real y : {Real(-1), Real(1)})
      for (const Real z : {-width, width}) low = std::min(low, (q * Vector3(x, y, z)).y());
  const Real speed = between(-30, 1), spin = between(-8, 8), aside = seed % 3 ? Real(0) : between(-1, 1);
  add_box(model, 1, {width, 1, width}, {0, -low, 0}, q, {speed, seed % 5 == 0 ? Real(-1) : Real(0), aside},
          {0, 0, spin});
  return model;
}

// A tetrahedron that falls on a locked box, turning.
inline Model tetrahedron_on_box(const Vector3& spin, Impacts impacts) {
  Model model = without_plane({Real(0.2), Real(0.6)});
  model.impacts = impacts;
  model.forces.gravity = {0, Real(-9.81), 0};
  add_box(model, 1, {2, Real(0.5), 2}, Vector3::Zero(), Quaternion::Identity(), Vector3::Zero(),
          Vector3::Zero(), true);
  const Body body = make_body(1, Matrix3::Identity() / 20);
  add(model, body,
      make_hull({{-0.25, -0.25, -0.25}, {0.75, -0.25, -0.25}, {-0.25, 0.75, -0.25}, {-0.25, -0.25, 0.75}}),
      make_motion(body, {0, Real(1.2), 0}, Quaternion::Identity(), Vector3::Zero(), spin));
  return model;
}

// Boxes and cones of unlike masses between a floor and two walls.
inline Model random_pile(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return static_cast<Real>(low + (high - low) * (static_cast<double>(random()) / 4294967296.0));
  };
  const auto vector = [&](double size) {
    Vector3 v;
    for (int k = 0; k < 3; ++k) v[k] = between(-size, size);
    return v;
  };
  Model model = floor({Real(0.4), Real(1.5)});
  for (const Real side : {Real(-1), Real(1)})
    model.planes.push_back({Vector3(side, Real(0.3), 0).normalized(), -1});
  model.plane_surfaces.assign(3, 1);
  for (int k = 0; k < 6; ++k) {
    const Real mass = std::pow(Real(10), between(-6, 6));
    const Vector3 p = Vector3(between(-0.6, 0.6), Real(0.5) * static_cast<Real>(k + 1), between(-0.3, 0.3));
    const Quaternion q = exponential(vector(2));
    const Vector3 v = vector(2), w = vector(3);
    if (k % 2 == 0) {
      add_box(model, mass, {Real(0.3), Real(0.2), Real(0.25)}, p, q, v, w);
    } else {
      const Body body = make_body(mass, Matrix3::Identity() * (mass / 10));
      add(model, body, Frustum{Real(0.3), Real(0.1), Real(-0.3), Real(0.3)}, make_motion(body, p, q, v, w));
    }
  }
  return model;
}

inline Model boxes_on_floor(int count, Real apart) {
  Model model = floor({0, Real(0.3)});
  for (int i = 0; i < count; ++i)
    box(model, {apart * static_cast<Real>(i % 40), Real(0.5), apart * (static_cast<Real>(i - i % 40) / 40)});
  return model;
}

// A box falls onto one of 200 beside each other, which a spring makes one matter of sweeps.
inline Model blow_among_many(Real restitution) {
  Model model = boxes_on_floor(200, Real(1.25));
  model.materials.assign(4, {restitution, Real(0.3)});
  box(model, {Real(0.125), Real(1.55), 0}, {0, -2, 0});
  model.forces.springs.push_back({0, {0, 0, 0}, 1, {0, 0, 0}, 1, Real(1.25), 0});
  return model;
}

// A ball falls on one of more than pass blows on at their instant.
inline Model ball_onto_many() {
  Model model = floor({0, 0});
  for (int i = 0; i < 300; ++i) {
    const int row = i / 20;
    ball(model, {Real(1.5) * static_cast<Real>(i % 20), Real(0.5), Real(1.5) * static_cast<Real>(row)});
  }
  ball(model, {0, Real(1.7), 0});
  return model;
}

inline Model chain_of_boxes(int count) {
  Model model = floor({0, Real(0.5)});
  for (int i = 0; i < count; ++i) {
    box(model, {Real(1.2) * static_cast<Real>(i), 2, 0}, {0, 0, static_cast<Real>(3 * (i % 3))});
    if (i > 0)
      model.joints.push_back({.body = i - 1,
                              .anchor = {Real(0.6), 0, Real(0.1)},
                              .to = i,
                              .to_anchor = {Real(-0.6), 0, Real(0.1)}});
  }
  return model;
}

// Joints that cannot both be closed.
inline Model held_in_two_places() {
  Model model = floor({0, Real(0.5)});
  box(model, {0, Real(0.5), 0}, {0, 0, 0});
  for (const Real x : {Real(0), Real(0.1)})
    model.joints.push_back({.body = 0, .to_anchor = {x, Real(0.5), 0}});
  return model;
}

inline Model two_boxes(Real place, Real speed, const Material& material, bool fall) {
  Model model = floor(material);
  if (!fall) model.forces.gravity.setZero();
  box(model, {0, Real(0.5), 0}, {speed, 0, 0}), box(model, {place, Real(0.5), 0});
  return model;
}

// A light ball that rolls towards one that it could not carry; boxes far away make fixed steps of the whole scene.
inline Model unlike_balls() {
  Model model = floor({Real(0.5), 0});
  ball(model, {0, Real(0.5), 0}, {4, 0, 0});
  ball(model, {8, Real(0.5), 0}, Vector3::Zero(), Real(1e18));
  for (const Real x : {Real(100), Real(200)}) box(model, {x, Real(0.5), 0});
  return model;
}

inline Model many_balls() {
  Model model = floor({0, 0});
  for (int i = 0; i < 520; ++i)
    ball(model, {static_cast<Real>(2 * (i % 30)), 1, static_cast<Real>(i - i % 30) / 15});
  return model;
}

inline Model overlapping_balls() {
  Model model = without_plane({Real(0.5), Real(0.2)});
  ball(model, Vector3::Zero(), {Real(0.1), 0, 0}), ball(model, {Real(0.9), 0, 0});
  return model;
}

inline Model with_drag(Model model, Real drag) {
  model.forces.drags.push_back({0, drag, 0, 0});
  return model;
}

/// On a vertical rail to the world, with a damper along it.
inline Model with_rail_and_damper(Model model, Real damping) {
  model.joints.push_back({.type = joint_types::slider,
                          .body = 0,
                          .to_anchor = model.motions[0].position,
                          .to_axis = Vector3::UnitY(),
                          .relative = model.motions[0].orientation});
  CoordinateLaw law;
  law.at.to_anchor = model.motions[0].position, law.at.axis = Vector3::UnitY();
  law.damping = damping;
  model.forces.coordinate_laws.push_back(law);
  return model;
}

inline Model as_constraints(Model model) {
  model.reduce_joints = false;
  return model;
}

inline Model at_once(Model model) {
  model.impacts = Impacts::simultaneous;
  return model;
}

inline Options forced(Options options) {
  options.force = true;
  return options;
}

inline Options by_events(const char* integrator, Time dt) {
  Options options = with(integrator, dt);
  options.path = "events";
  return options;
}

}  // namespace cylon::engine
