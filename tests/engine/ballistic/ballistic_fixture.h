// Scenes for the ballistic stepper, reference files, and runs.
#pragma once

#include "engine/ballistic/ballistic.h"
#include "tests/engine/same_bits.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cylon::engine::ballistic_test {

inline constexpr Real ulp = std::numeric_limits<Real>::epsilon();

inline nlohmann::json truth(const std::string& name) {
  std::ifstream in(std::string(source_dir) + "/tests/data/truth/" + name + ".json");
  return nlohmann::json::parse(in);
}

inline double number(const nlohmann::json& j) {
  return j.is_string() ? std::stod(j.get<std::string>()) : j.get<double>();
}
inline Real real(const nlohmann::json& j) { return static_cast<Real>(number(j)); }
inline Vector3 vector(const nlohmann::json& j) { return {real(j[0]), real(j[1]), real(j[2])}; }
inline Quaternion quaternion(const nlohmann::json& j) {
  return {real(j[0]), real(j[1]), real(j[2]), real(j[3])};
}

/// A model in which every pair of surfaces has one material.
inline Model spheres_of(const Material& material, const Vector3& gravity = Vector3::Zero()) {
  Model model;
  model.surface_count = 1;
  model.materials = {material};
  model.forces.gravity = gravity;
  return model;
}

/// Inertia factor 2/5 is a solid sphere's.
inline void add_sphere(Model& model, Real mass, Real radius, const Vector3& position, const Vector3& v,
                       const Vector3& w = Vector3::Zero(), Real factor = Real(0.4), bool locked = false) {
  model.bodies.push_back(make_body(mass, Matrix3::Identity() * (factor * mass * radius * radius), locked));
  model.motions.push_back(make_motion(model.bodies.back(), position, Quaternion::Identity(), v, w));
  model.shapes.emplace_back(Sphere{radius});
  model.surfaces.push_back(0);
}

inline void add_plane(Model& model, const Vector3& normal, Real offset) {
  model.planes.push_back({normal.normalized(), offset});
  model.plane_surfaces.push_back(0);
}

/// The six walls of a box about the origin, turned by r.
inline void add_box(Model& model, Real half, const Quaternion& r = Quaternion::Identity()) {
  for (int axis = 0; axis < 3; ++axis)
    for (const Real side : {Real(-1), Real(1)})
      add_plane(model, r * Vector3(side * Vector3::Unit(axis)), -half);
}

struct Outcome {
  std::vector<Motion> motions;
  std::vector<Impact> impacts;
  std::optional<Handover> handover;
};

inline Outcome run(const Model& model, Time dt, int steps) {
  EXPECT_EQ(ballistic_unsupported(model).value_or(""), "");
  const auto stepper = make_ballistic(model, dt);
  Outcome result;
  for (int i = 0; i < steps && !stepper->handover(); ++i) {
    stepper->step();
    result.impacts.insert(result.impacts.end(), stepper->impacts().begin(), stepper->impacts().end());
  }
  stepper->read(result.motions);
  result.handover = stepper->handover();
  return result;
}

inline Vector3 velocity_of(const Model& model, const Outcome& run, std::size_t i) {
  return velocity(model.bodies[i], run.motions[i]);
}
inline Vector3 spin_of(const Model& model, const Outcome& run, std::size_t i) {
  return angular_velocity(model.bodies[i], run.motions[i]);
}

/// Sum of m v^2/2 + w.L/2 - m g.p over the bodies that are not locked; in double, so that the sum adds
/// nothing.
inline double energy(const Model& model, const std::vector<Motion>& motions) {
  double sum = 0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (model.bodies[i].locked) continue;
    const Eigen::Vector3d k = motions[i].momentum.cast<double>(),
                          l = motions[i].angular_momentum.cast<double>();
    const Eigen::Vector3d w = angular_velocity(model.bodies[i], motions[i]).cast<double>();
    const double m = static_cast<double>(model.bodies[i].mass);
    sum += k.squaredNorm() / (2 * m) + w.dot(l) / 2 -
           m * model.forces.gravity.cast<double>().dot(motions[i].position.cast<double>());
  }
  return sum;
}

inline Eigen::Vector3d momentum(const std::vector<Motion>& motions) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Motion& m : motions) sum += m.momentum.cast<double>();
  return sum;
}

/// About the origin: sum of p x K + L.
inline Eigen::Vector3d angular_momentum(const std::vector<Motion>& motions) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Motion& m : motions)
    sum += m.position.cast<double>().cross(m.momentum.cast<double>()) + m.angular_momentum.cast<double>();
  return sum;
}

inline Real angle_between(const Quaternion& p, const Quaternion& q) {
  const Real chord = std::min((p.coeffs() - q.coeffs()).norm(), (p.coeffs() + q.coeffs()).norm());
  return 4 * std::asin(std::min(Real(1), chord / 2));
}

/// Largest difference of positions and velocities [m, m/s].
inline Real distance(const Model& model, const std::vector<Motion>& a, const std::vector<Motion>& b) {
  Real largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, (a[i].position - b[i].position).norm());
    largest = std::max(largest, (a[i].momentum - b[i].momentum).norm() / model.bodies[i].mass);
  }
  return largest;
}

/// Numbers in [0, 1), the same everywhere: a linear congruential generator (Knuth's MMIX).
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  Real operator()() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<Real>(state_ >> 40) / Real(1u << 24);
  }
  Real symmetric() { return 2 * (*this)() - 1; }
  Vector3 vector() {
    const Real x = symmetric(), y = symmetric();
    return {x, y, symmetric()};
  }

 private:
  std::uint64_t state_;
};

/// Spheres at random places of a cubic lattice with `side`^3 places within a cube about the origin of half
/// width `half`, with random velocities of about 1 m/s; masses and radii vary by 30 %.
inline void add_gas(Model& model, int side, Real half, Real radius, std::uint64_t seed,
                    bool spinning = false) {
  Dice dice(seed);
  const Real pitch = 2 * (half - Real(1.6) * radius) / static_cast<Real>(side - 1);
  const Real play = (pitch / 2 - Real(1.3) * radius) / 2;
  for (int i = 0; i < side * side * side; ++i) {
    const int layer = i / (side * side);
    const Vector3 place(static_cast<Real>(i % side), static_cast<Real>(i / side % side),
                        static_cast<Real>(layer));
    const Vector3 corner = Vector3::Constant(Real(1.6) * radius - half);
    const Vector3 wobble = std::min(play, Real(0.3) * radius) * dice.vector();
    const Real size = 1 + Real(0.25) * dice.symmetric();
    const Vector3 v = dice.vector(), w = dice.vector();
    add_sphere(model, 1 + Real(0.3) * dice.symmetric(), radius * size, corner + pitch * place + wobble, v,
               spinning ? Vector3(5 * w) : Vector3(Vector3::Zero()));
  }
}

}  // namespace cylon::engine::ballistic_test
