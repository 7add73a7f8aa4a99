// Random scenes from a seed, how they run through the in-house simulator, and how far two motions are apart.
#pragma once

#include "harness/core/simulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace cylon::core {

inline constexpr int scene_count = 50;
inline constexpr double dt = 0.01;
inline constexpr int steps = 40;

/// What may be in a scene.
struct Ingredients {
  bool outside = true;  ///< Gravity, pins, drives, drag: what acts from outside.
  bool losses = true;   ///< Damping and drag.
  bool joints = true;
  bool contacts = false;  ///< Spheres over a plane, and nothing else but gravity.
  double friction = 0;
};

class Random {
 public:
  explicit Random(int seed) : engine_(static_cast<std::uint32_t>(seed) * 7919u + 17u) {}
  /// Uniform; by hand, for the same numbers everywhere.
  double in(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  int below(int n) { return static_cast<int>(in(0, n)); }
  Vector3 vector(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  Quaternion turn() { return Quaternion(in(-1, 1), in(-1, 1), in(-1, 1), in(-1, 1) + 1e-3).normalized(); }
  Matrix3 inertia(double size) {
    const Vector3 r2(in(0.2, 1), in(0.2, 1), in(0.2, 1));  // moments of a box: they obey the triangle's law
    const Matrix3 a = turn().toRotationMatrix();
    const Matrix3 i =
        size * a * Vector3(r2.y() + r2.z(), r2.x() + r2.z(), r2.x() + r2.y()).asDiagonal() * a.transpose();
    return (i + i.transpose()) / 2;
  }

 private:
  std::mt19937 engine_;
};

inline Scene random_scene(int seed, const Ingredients& use) {
  Random random(seed);
  Scene scene;
  const int n = 2 + random.below(2);
  for (int i = 0; i < n; ++i) {
    Body body;
    body.name = std::string(1, static_cast<char>('a' + i));
    body.mass = random.in(0.5, 2);
    body.inertia = random.inertia(0.3);
    body.initial = {random.vector(1) + Vector3(2.5 * i, 0, 0), random.turn(), random.vector(1),
                    random.vector(2)};
    if (use.contacts) {
      body.shape = Sphere{random.in(0.2, 0.4)};
      body.inertia = Matrix3::Identity() * random.in(0.02, 0.06);
      body.collide = true;
      body.initial.position.y() = random.in(0.5, 0.9);
    }
    scene.bodies.push_back(body);
  }
  if (use.outside || use.contacts) {
    scene.forces.emplace_back(UniformGravity{use.contacts ? Vector3(0, -9.81, 0) : random.vector(10)});
  }
  if (use.contacts) {
    scene.planes.push_back({"floor", Vector3::UnitY(), 0});
    scene.materials.push_back({{"*", "*"}, random.in(0.3, 0.9), use.friction});
    return scene;
  }
  for (int i = 0; i + 1 < n; ++i) {
    scene.forces.emplace_back(Spring{i, random.vector(0.4), i + 1, random.vector(0.4), random.in(2, 20),
                                     random.in(0.1, 1.5), use.losses ? random.in(0, 0.5) : 0});
  }
  if (use.outside) {
    scene.forces.emplace_back(Spring{0, random.vector(0.4), world, random.vector(3), random.in(2, 20),
                                     random.in(0.1, 1), use.losses ? random.in(0, 0.5) : 0});
    if (use.losses) {
      scene.forces.emplace_back(Drive{n - 1, random.vector(3), random.in(1, 4)});
      scene.forces.emplace_back(Drag{0, random.in(0, 0.4), random.in(0, 0.1), random.in(0, 0.3)});
    }
  }
  if (use.joints && random.below(2) == 0) {  // the next body onto the first, moving as one about the joint
    BodyState &a = scene.bodies[0].initial, &b = scene.bodies[1].initial;
    const Vector3 point = a.position + random.vector(0.5);
    b.position = point + random.vector(0.5);
    const Vector3 at = a.velocity + a.angular_velocity.cross(point - a.position);
    b.velocity = at + b.angular_velocity.cross(b.position - point);
    scene.joints.push_back({JointType::ball, 0, 1, point});
  }
  return scene;
}

inline Setup with(const std::string& integrator, double step = dt) {
  Setup setup;
  setup.dt = step;
  setup.integrator = integrator;
  if (integrator == "auto") setup.tolerance = 1e-10;
  return setup;
}

/// The motion after `count` steps, or nothing where the simulator refuses.
inline State run(const Scene& scene, const Setup& setup, int count = steps) {
  const auto simulator = make_simulator();
  EXPECT_EQ(simulator->unsupported(scene, setup).value_or(""), "");
  simulator->load(scene, setup);
  for (int i = 0; i < count; ++i) simulator->step();
  State state;
  simulator->read(state);
  return state;
}

inline double angle(const Quaternion& a, const Quaternion& b) {
  const double d = std::min((a.coeffs() - b.coeffs()).norm(), (a.coeffs() + b.coeffs()).norm());
  return 4 * std::asin(std::min(1.0, d / 2));
}

/// The largest difference, SI units mixed.
inline double distance(const State& a, const State& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    worst = std::max({worst, (a[i].position - b[i].position).norm(), (a[i].velocity - b[i].velocity).norm(),
                      (a[i].angular_velocity - b[i].angular_velocity).norm(),
                      angle(a[i].orientation, b[i].orientation)});
    if (!std::isfinite(worst)) return std::numeric_limits<double>::infinity();
  }
  return worst;
}

/// What two runs of the same motion in other numbers may part by.  Fixed steps do the same operations, each
/// rounded: steps x at most 14 evaluations of the forces x ulp, of numbers up to 10, grown up to tenfold by
/// the motion. Auto: both keep 1e-10 of their scales, of up to 10 m and m/s.
inline double bound(const std::string& integrator) {
  return integrator == "auto" ? 2 * 10 * 1e-10 : steps * 14 * 100 * std::numeric_limits<double>::epsilon();
}

/// One of the integrators, in turn, that take joints.
inline std::string integrator_of(int seed) {
  const char* const names[] = {"rk4", "velocity-verlet", "yoshida4", "rk8", "auto"};
  return names[seed % 5];
}

}  // namespace cylon::core
