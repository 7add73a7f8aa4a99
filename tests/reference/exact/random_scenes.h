// Scenes with general values inside the domain of each smooth solution: no zeros, no axis-aligned luck.
#pragma once

#include "harness/core/scene.h"

#include <random>
#include <set>
#include <string>

namespace cylon::exact {

class RandomScenes {
 public:
  explicit RandomScenes(unsigned seed) : random_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }

  core::Vector3 vector(double size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }

  core::Quaternion rotation() {
    std::normal_distribution<double> normal;
    return core::Quaternion(normal(random_), normal(random_), normal(random_), normal(random_)).normalized();
  }

  /// A full tensor with the given principal moments in a random frame.
  core::Matrix3 inertia(const core::Vector3& moments) {
    const core::Matrix3 r = rotation().toRotationMatrix();
    const core::Matrix3 full = r * moments.asDiagonal() * r.transpose();
    return (full + full.transpose()) / 2;
  }

  core::Body body(const core::Vector3& moments) {
    core::Body b;
    b.name = "body";
    b.mass = between(0.5, 3);
    b.inertia = inertia(moments);
    b.initial = {vector(2), rotation(), vector(2), vector(4)};
    return b;
  }

  static bool knows(const std::string& solution) {
    static const std::set<std::string> names = {"projectile",         "spring_zero_length",  "spring_orbit",
                                                "free_symmetric_top", "free_asymmetric_top", "heavy_top"};
    return names.contains(solution);
  }

  core::Scene scene(const std::string& solution) {
    core::Scene s;
    if (solution == "heavy_top") return heavy_top();
    if (solution == "free_symmetric_top") {
      const double transverse = between(0.3, 1);
      s.bodies.push_back(body({transverse, transverse, between(0.1, 1.9) * transverse}));
    } else if (solution == "free_asymmetric_top") {
      s.bodies.push_back(body({between(0.5, 0.7), between(0.75, 0.95), between(1, 1.2)}));
    } else {
      const double moment = between(0.1, 1);
      s.bodies.push_back(body({moment, moment, moment}));
      s.bodies[0].inertia = moment * core::Matrix3::Identity();
    }
    if (solution != "spring_orbit") s.forces.emplace_back(core::UniformGravity{vector(10)});
    if (solution == "spring_orbit" || solution == "spring_zero_length") {
      core::Spring spring;
      spring.to_anchor = vector(1);
      spring.stiffness = between(5, 80);
      spring.rest_length = solution == "spring_orbit" ? between(0.2, 2) : 0;
      s.forces.emplace_back(spring);
      if (solution == "spring_zero_length")
        s.forces.emplace_back(core::Spring{0, {0, 0, 0}, core::world, vector(1), 7, 0, 0});
    }
    return s;
  }

  /// A top whose axis, pivot and vertical point anywhere.
  core::Scene heavy_top() {
    core::Scene s;
    const double transverse = between(0.002, 0.02), axial = between(0.1, 1.9) * transverse;
    core::Body b = body({1, 1, 1});
    const core::Quaternion frame = rotation();
    const core::Matrix3 r = frame.toRotationMatrix();
    const core::Matrix3 full = r * core::Vector3(transverse, transverse, axial).asDiagonal() * r.transpose();
    b.inertia = (full + full.transpose()) / 2;
    core::Joint joint;
    joint.point = vector(0.5);
    const core::Vector3 d = b.initial.orientation * core::Vector3(r.col(2)) * (between(-1, 1) < 0 ? -1 : 1);
    b.initial.position = joint.point + between(0.05, 0.3) * d;
    b.initial.angular_velocity = between(-40, 40) * d + vector(5);
    b.initial.velocity = b.initial.angular_velocity.cross(b.initial.position - joint.point);
    s.bodies.push_back(b);
    s.joints.push_back(joint);
    s.forces.emplace_back(core::UniformGravity{vector(12)});
    return s;
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace cylon::exact
