// Scenes with general values inside the domain of each solution with contacts.
#pragma once

#include "tests/reference/exact/random_scenes.h"

#include <stdexcept>

namespace cylon::exact {

class ContactScenes {
 public:
  explicit ContactScenes(unsigned seed) : random_(seed) {}

  core::Scene scene(const std::string& solution) {
    if (solution == "sphere_two_walls") return two_walls();
    if (solution == "sphere_row") return row();
    if (solution == "sliding_block") return turned(block());
    if (solution == "rough_sphere") return turned(rough());
    throw std::runtime_error("no scenes with contacts for " + solution);
  }

 private:
  double between(double low, double high) { return random_.between(low, high); }

  // A solid or hollow ball with a spin.
  core::Body ball(const std::string& name, double radius) {
    core::Body b;
    b.name = name;
    b.mass = between(0.5, 3);
    b.shape = core::Sphere{radius};
    b.collide = true;
    b.inertia = between(0.35, 0.66) * b.mass * radius * radius * core::Matrix3::Identity();
    b.initial.orientation = random_.rotation();
    b.initial.angular_velocity = random_.vector(4);
    return b;
  }

  // A unit vector and one at right angles, in general position.
  core::Vector3 direction() { return random_.rotation() * core::Vector3::UnitY(); }

  // Between walls in general position; each wall with its own restitution.
  core::Scene two_walls() {
    core::Scene s;
    const core::Vector3 n = direction(), centre = random_.vector(1);
    const double half = between(0.5, 2);
    s.planes = {{"left", n, n.dot(centre) - half}, {"right", -n, -n.dot(centre) - half}};
    core::Body b = ball("ball", between(0.05, 0.3));
    b.initial.position = centre + between(-0.1, 0.1) * n;
    b.initial.velocity = random_.vector(1) + (between(0, 1) < 0.5 ? -1 : 1) * between(2, 5) * n;
    s.bodies = {b};
    s.materials = {{{"ball", "left"}, between(0.6, 1), 0}, {{"ball", "right"}, between(0.6, 1), 0}};
    return s;
  }

  // Four balls of any size on a line along z, the first fast, in a lift that falls and drifts.
  core::Scene row() {
    core::Scene s;
    const core::Vector3 origin = random_.vector(1), drift = random_.vector(1);
    double z = 0, before = 0;
    for (int i = 0; i < 4; ++i) {
      const double radius = between(0.1, 0.4);
      core::Body b = ball("ball" + std::to_string(i), radius);
      z += i == 0 ? 0 : before + radius + between(0.05, 0.5);
      before = radius;
      b.initial.position = {origin.x(), origin.y(), origin.z() + z};
      b.initial.velocity = {drift.x(), drift.y(), drift.z() + (i == 0 ? between(3, 6) : between(-1, 1))};
      s.bodies.push_back(b);
    }
    s.forces.emplace_back(core::UniformGravity{random_.vector(10)});
    s.materials = {{{"*", "*"}, between(0.4, 1), 0}};
    return s;
  }

  // Down a slope along x, which turned() takes to any direction; slides, stops, turns back or stays.
  core::Scene block() {
    core::Scene s;
    const double angle = between(0.1, 0.5), h = between(0.05, 0.2);
    core::Body b = ball("block", 1);
    b.inertia = b.mass * core::Vector3(0.3, 0.5, 0.4).asDiagonal();
    b.shape = core::Box{{between(0.5, 1), h, between(0.5, 1)}};
    b.initial = {};
    b.initial.position = {between(-2, 2), h, between(-2, 2)};
    b.initial.velocity = {between(-4, 4), 0, 0};
    s.bodies = {b};
    s.planes = {{"slope", {0, 1, 0}, 0}};
    s.materials = {{{"*", "*"}, 0, between(0.1, 0.8)}};
    s.forces.emplace_back(core::UniformGravity{9.81 * core::Vector3(std::sin(angle), -std::cos(angle), 0)});
    return s;
  }

  // On a level floor with any spin and fall, or on a slope along x with slip along it.
  core::Scene rough() {
    core::Scene s;
    const double radius = between(0.1, 0.5), slope = between(0, 1) < 0.5 ? 0 : between(0.1, 0.9);
    core::Body b = ball("ball", radius);
    b.initial.position = {between(-2, 2), radius + (between(0, 1) < 0.3 ? 0 : between(0.1, 1)),
                          between(-2, 2)};
    b.initial.velocity = {between(-3, 3), between(-3, 3), between(-3, 3)};
    if (slope > 0) {
      b.initial.velocity.z() = 0;
      b.initial.angular_velocity = {0, between(-3, 3), between(-9, 9)};
    }
    if (b.initial.position.y() == radius) b.initial.velocity.y() = 0;
    s.bodies = {b};
    s.planes = {{"floor", {0, 1, 0}, 0}};
    s.materials = {{{"*", "*"}, between(0.2, 0.6), between(0.05, 0.5)}};
    s.forces.emplace_back(core::UniformGravity{9.81 * core::Vector3(std::sin(slope), -std::cos(slope), 0)});
    return s;
  }

 public:
  /// All of space turned by s and shifted by a; the walls too.
  static core::Scene moved(core::Scene scene, const core::Quaternion& s, const core::Vector3& a) {
    for (core::Body& body : scene.bodies) {
      core::BodyState& b = body.initial;
      b = {s * b.position + a, (s * b.orientation).normalized(), s * b.velocity, s * b.angular_velocity};
    }
    for (core::Plane& plane : scene.planes) {
      plane.normal = s * plane.normal;
      plane.offset += plane.normal.dot(a);
    }
    for (core::Force& force : scene.forces) {
      if (auto* g = std::get_if<core::UniformGravity>(&force)) g->acceleration = s * g->acceleration;
    }
    return scene;
  }

 private:
  core::Scene turned(const core::Scene& scene) { return moved(scene, random_.rotation(), {0, 0, 0}); }

  RandomScenes random_;
};

}  // namespace cylon::exact
