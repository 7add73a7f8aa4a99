// Small models for the tests of the pile stepper.
#pragma once

#include "engine/pile/pile.h"
#include "tests/engine/momenta.h"

#include <cmath>
#include <limits>
#include <vector>

namespace cylon::engine {

inline constexpr Real g = Real(9.81);
inline constexpr Real eps = std::numeric_limits<Real>::epsilon();

/// One surface for all; gravity along -y; a floor at y = 0 unless told otherwise.
inline Model pile_model(Real restitution, Real friction, bool floor = true) {
  Model model;
  model.forces.gravity = Vector3(0, -g, 0);
  model.surface_count = 1;
  model.materials = {Material{restitution, friction}};
  if (floor) model.planes = {Plane{Vector3(0, 1, 0), 0}}, model.plane_surfaces = {0};
  return model;
}

inline void add_body(Model& model, const Body& body, const Shape& shape, const Vector3& position,
                     const Vector3& velocity = Vector3::Zero(), const Vector3& spin = Vector3::Zero(),
                     const Quaternion& orientation = Quaternion::Identity()) {
  model.bodies.push_back(body);
  model.motions.push_back(make_motion(body, position, orientation, velocity, spin));
  model.shapes.push_back(shape);
  model.surfaces.push_back(0);
}

inline void add_ball(Model& model, Real mass, Real radius, const Vector3& position,
                     const Vector3& velocity = Vector3::Zero(), const Vector3& spin = Vector3::Zero()) {
  const Matrix3 inertia = Matrix3::Identity() * (Real(0.4) * mass * radius * radius);
  add_body(model, make_body(mass, inertia), Sphere{radius}, position, velocity, spin);
}

inline void add_box(Model& model, Real mass, const Vector3& half, const Vector3& position,
                    const Vector3& velocity = Vector3::Zero(), const Vector3& spin = Vector3::Zero(),
                    const Quaternion& orientation = Quaternion::Identity()) {
  const Vector3 s = half.cwiseAbs2();
  const Matrix3 inertia =
      mass / 3 * Vector3(s[1] + s[2], s[0] + s[2], s[0] + s[1]).asDiagonal().toDenseMatrix();
  add_body(model, make_body(mass, inertia), Box{half}, position, velocity, spin, orientation);
}

inline std::vector<Motion> after(Stepper& stepper, int steps) {
  for (int k = 0; k < steps; ++k) stepper.step();
  std::vector<Motion> motions;
  stepper.read(motions);
  return motions;
}

/// Kinetic and potential energy [J].
inline double mechanical_energy(const Model& model, const std::vector<Motion>& motions) {
  double sum = 0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Motion& m = motions[i];
    sum += static_cast<double>(m.momentum.squaredNorm() / (2 * model.bodies[i].mass) +
                               m.angular_momentum.dot(angular_velocity(model.bodies[i], m)) / 2 -
                               model.bodies[i].mass * model.forces.gravity.dot(m.position));
  }
  return sum;
}

/// Balls dropped in a crooked lattice into an open box of the given width in balls.
inline Model ball_pile(int side, int layers, Real restitution, Real friction) {
  Model model = pile_model(restitution, friction);
  const Real half = Real(0.55) * static_cast<Real>(side) + Real(0.1);
  for (const Vector3& n : {Vector3(1, 0, 0), Vector3(-1, 0, 0), Vector3(0, 0, 1), Vector3(0, 0, -1)})
    model.planes.push_back({n, -half}), model.plane_surfaces.push_back(0);
  for (int i = 0; i < side * side * layers; ++i) {
    const int x = i % side, z = i / side % side, y = i / side / side;
    add_ball(model, 1, Real(0.5),
             Vector3(Real(1.1) * static_cast<Real>(x) - half + Real(0.65) +
                         Real(0.01) * static_cast<Real>(i * 7 % 11),
                     Real(0.6) + Real(1.1) * static_cast<Real>(y),
                     Real(1.1) * static_cast<Real>(z) - half + Real(0.65) +
                         Real(0.01) * static_cast<Real>(i * 5 % 13)));
  }
  return model;
}

/// The deepest overlap of equal balls with each other and with the planes [m].
inline Real deepest(const Model& model, const std::vector<Motion>& motions) {
  Real depth = 0;
  const auto radius = [&](std::size_t i) { return std::get<Sphere>(model.shapes[i]).radius; };
  for (std::size_t i = 0; i < motions.size(); ++i) {
    for (const Plane& plane : model.planes)
      depth = std::max(depth, radius(i) - (plane.normal.dot(motions[i].position) - plane.offset));
    for (std::size_t j = i + 1; j < motions.size(); ++j)
      depth = std::max(depth, radius(i) + radius(j) - (motions[i].position - motions[j].position).norm());
  }
  return depth;
}

}  // namespace cylon::engine
