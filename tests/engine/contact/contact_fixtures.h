// Models of spheres and boxes that touch, and a run of the event stepper over them.
#pragma once

#include "engine/event_stepper.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace cylon::engine {

/// Bodies have surface 0, planes surface 1; gravity 9.81 m/s^2 down.
inline Model without_plane(const Material& material) {
  Model model;
  model.surface_count = 2;
  model.materials.assign(4, material);
  return model;
}

inline Model with_plane(const Vector3& normal, Real offset, const Material& material) {
  Model model = without_plane(material);
  model.planes.push_back({normal, offset});
  model.plane_surfaces.push_back(1);
  model.forces.gravity = {0, Real(-9.81), 0};
  return model;
}

inline void add(Model& model, const Body& body, const Shape& shape, const Motion& motion) {
  model.bodies.push_back(body);
  model.shapes.push_back(shape);
  model.surfaces.push_back(0);
  model.motions.push_back(motion);
}

inline void add_sphere(Model& model, Real mass, Real radius, const Vector3& p, const Vector3& v,
                       const Vector3& w, bool locked = false) {
  const Body body = make_body(mass, Matrix3::Identity() * (Real(0.4) * mass * radius * radius), locked);
  add(model, body, Sphere{radius}, make_motion(body, p, Quaternion::Identity(), v, w));
}

inline void add_box(Model& model, Real mass, const Vector3& half, const Vector3& p, const Quaternion& q,
                    const Vector3& v, const Vector3& w, bool locked = false) {
  const Vector3 squares = half.cwiseProduct(half);
  const Matrix3 inertia = (mass / 3 * (Vector3::Constant(squares.sum()) - squares)).asDiagonal();
  const Body body = make_body(mass, inertia, locked);
  add(model, body, Box{half}, make_motion(body, p, q, v, w));
}

struct Trial {
  explicit Trial(const Model& m, double step_size, const char* integrator = "dop853")
      : model(m), stepper(m, *find_integrator(integrator), step_size, Real(1e-13)), dt(step_size) {
    stepper.read(motions);
  }

  void step() {
    stepper.step();
    stepper.read(motions);
    impacts.insert(impacts.end(), stepper.impacts().begin(), stepper.impacts().end());
    time = static_cast<double>(++steps) * dt;
  }
  void until(double end) {
    while (time < end - dt / 2) step();
  }
  const Motion& motion(std::size_t i) const { return motions[i]; }
  Vector3 velocity(std::size_t i) const { return engine::velocity(model.bodies[i], motions[i]); }
  Vector3 spin(std::size_t i) const { return angular_velocity(model.bodies[i], motions[i]); }
  /// Kinetic and potential [J].
  Real energy() const {
    Real sum = 0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
      if (model.bodies[i].locked) continue;
      sum += velocity(i).dot(motions[i].momentum) / 2 + spin(i).dot(motions[i].angular_momentum) / 2 -
             model.bodies[i].mass * model.forces.gravity.dot(motions[i].position);
    }
    return sum;
  }
  Vector3 momentum() const {
    Vector3 sum = Vector3::Zero();
    for (const Motion& m : motions) sum += m.momentum;
    return sum;
  }
  Vector3 angular_momentum() const {
    Vector3 sum = Vector3::Zero();
    for (const Motion& m : motions) sum += m.position.cross(m.momentum) + m.angular_momentum;
    return sum;
  }

  Model model;
  EventStepper stepper;
  double dt;
  double time = 0;
  long steps = 0;
  std::vector<Motion> motions;
  std::vector<Impact> impacts;
};

}  // namespace cylon::engine
