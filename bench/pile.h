// Equal spheres as a lattice in an open box, and how deep they overlap.
#pragma once

#include "harness/core/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace cylon::bench {

inline constexpr double radius = 0.5, mass = 1, friction = 0.5;

/// Layers of `side` by `side` spheres 1.1 m apart and a little out of line, the lowest centres at height
/// `lowest`, the layers `rise` above each other [m]; no restitution.
inline core::Scene pile(std::int64_t count, std::int64_t side, double lowest, double rise) {
  const double half = 0.55 * static_cast<double>(side) + 0.1;
  core::Scene scene;
  scene.forces = {core::UniformGravity{}};
  scene.planes = {{"floor", {0, 1, 0}, 0},
                  {"west", {1, 0, 0}, -half},
                  {"east", {-1, 0, 0}, -half},
                  {"north", {0, 0, 1}, -half},
                  {"south", {0, 0, -1}, -half}};
  scene.materials = {{{"*", "*"}, 0, friction}};
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t layer = i / side / side;
    const double x = static_cast<double>(i % side), z = static_cast<double>(i / side % side),
                 y = static_cast<double>(layer);
    core::Body ball;
    ball.name = fmt::format("ball{}", i);
    ball.mass = mass;
    ball.inertia = core::Matrix3::Identity() * (0.4 * mass * radius * radius);
    ball.shape = core::Sphere{radius};
    ball.collide = true;
    ball.initial.position = {1.1 * x - half + 0.65 + 0.01 * static_cast<double>(i * 7 % 11),
                             lowest + rise * y,
                             1.1 * z - half + 0.65 + 0.01 * static_cast<double>(i * 5 % 13)};
    scene.bodies.push_back(ball);
  }
  return scene;
}

/// The deepest overlap of two balls or of a ball with a plane [m].
inline double overlap(const core::Scene& scene, const core::State& state) {
  double worst = 0;
  std::vector<core::Vector3> sorted;
  for (const core::BodyState& body : state) sorted.push_back(body.position);
  std::sort(sorted.begin(), sorted.end(),
            [](const core::Vector3& a, const core::Vector3& b) { return a.x() < b.x(); });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (const core::Plane& plane : scene.planes)
      worst = std::max(worst, radius - (plane.normal.dot(sorted[i]) - plane.offset));
    for (std::size_t j = i + 1; j < sorted.size() && sorted[j].x() < sorted[i].x() + 2 * radius; ++j)
      worst = std::max(worst, 2 * radius - (sorted[i] - sorted[j]).norm());
  }
  return worst;
}

}  // namespace cylon::bench
