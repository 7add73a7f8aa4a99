#include "tests/mutants/matrix/restated.h"

#include "harness/core/worst.h"

#include <algorithm>
#include <cmath>

namespace cylon::mutants {

using core::Matrix3;
using core::Quaternion;
using core::Scene;
using core::State;
using core::Vector3;

Scene Restated::operator()(const Scene& scene) const {
  Scene result = words(scene);
  for (core::Body& b : result.bodies) b.initial.velocity += boost;
  return result;
}

State Restated::operator()(const State& state, double time) const {
  State result = words(state);
  for (core::BodyState& b : result) b.position += time * boost, b.velocity += boost;
  return result;
}

Restated turned(const Quaternion& s) { return {.words = {.turn = s.toRotationMatrix()}}; }

Restated mirrored() {
  const Matrix3 m = Vector3(-1, 1, 1).asDiagonal();
  return {.words = {.turn = m, .own = m}};
}

Restated boosted(const Vector3& velocity) { return {.boost = velocity}; }

Restated heavier(double factor) { return {.words = {.mass = factor}}; }

// q' = q c: body vectors a become C^T a.
Restated other_body_axes(const Quaternion& c) { return {.words = {.own = c.toRotationMatrix().transpose()}}; }

Scene in_reverse(Scene scene) {
  const int n = static_cast<int>(scene.bodies.size());
  std::reverse(scene.bodies.begin(), scene.bodies.end());
  const auto move = [n](int& body) { body = body == core::world ? body : n - 1 - body; };
  for (core::Force& f : scene.forces) {
    if (auto* k = std::get_if<core::Spring>(&f)) move(k->body), move(k->to);
    if (auto* d = std::get_if<core::Drag>(&f)) move(d->body);
  }
  return scene;
}

Scene started_from(Scene scene, const State& start) {
  for (std::size_t i = 0; i < start.size(); ++i) scene.bodies[i].initial = start[i];
  return scene;
}

double apart(const State& a, const State& b) {
  double result = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const Eigen::Vector4d p = a[i].orientation.coeffs(), q = b[i].orientation.coeffs();
    const double chord = std::min((p - q).norm(), (p + q).norm());
    for (const double d : {(a[i].position - b[i].position).norm(), (a[i].velocity - b[i].velocity).norm(),
                           (a[i].angular_velocity - b[i].angular_velocity).norm(), 2 * chord})
      result = core::worst(d, result);
  }
  return result;
}

}  // namespace cylon::mutants
