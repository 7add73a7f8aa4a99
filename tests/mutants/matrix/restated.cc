#include "tests/mutants/matrix/restated.h"

#include "harness/core/worst.h"

#include <algorithm>
#include <cmath>

namespace cylon::mutants {
namespace {

using core::Matrix3;
using core::Quaternion;
using core::Scene;
using core::State;
using core::Vector3;

Vector3 through(const Restatement::Map& map, const Vector3& v) { return map ? map(v) : v; }

core::BodyState restated(const Restatement& r, const core::BodyState& s) {
  return {through(r.place, s.position), r.orientation ? r.orientation(s.orientation) : s.orientation,
          through(r.direction, s.velocity), through(r.turning, s.angular_velocity)};
}

}  // namespace

Scene Restatement::operator()(Scene s) const {
  for (core::Body& b : s.bodies) {
    b.initial = restated(*this, b.initial);
    b.initial.velocity += boost;
    b.mass *= mass;
    b.inertia *= mass;
    if (inertia) b.inertia = inertia(b.inertia);
  }
  for (core::Force& f : s.forces) {
    if (auto* g = std::get_if<core::UniformGravity>(&f))
      g->acceleration = through(direction, g->acceleration);
    if (auto* k = std::get_if<core::Spring>(&f)) {
      k->anchor = through(own, k->anchor);
      k->to_anchor = through(k->to == core::world ? place : own, k->to_anchor);
      k->stiffness *= mass, k->damping *= mass;
    }
    if (auto* d = std::get_if<core::Drag>(&f)) d->linear *= mass, d->angular *= mass;
  }
  for (core::Plane& p : s.planes) p.normal = through(direction, p.normal);
  return s;
}

State Restatement::operator()(State s, double time) const {
  for (core::BodyState& b : s) {
    b = restated(*this, b);
    b.position += time * boost, b.velocity += boost;
  }
  return s;
}

Restatement turned(const Quaternion& s) {
  Restatement r;
  r.place = r.direction = r.turning = [=](const Vector3& v) -> Vector3 { return s * v; };
  r.orientation = [=](const Quaternion& q) { return s * q; };
  return r;
}

// M = diag(-1, 1, 1) in the world and in body axes: w -> -M w, (w, x, y, z) -> (w, x, -y, -z).
Restatement mirrored() {
  Restatement r;
  r.place = r.direction = r.own = [](const Vector3& v) -> Vector3 { return {-v.x(), v.y(), v.z()}; };
  r.turning = [](const Vector3& w) -> Vector3 { return {w.x(), -w.y(), -w.z()}; };
  r.orientation = [](const Quaternion& q) { return Quaternion(q.w(), q.x(), -q.y(), -q.z()); };
  r.inertia = [](const Matrix3& i) -> Matrix3 {
    const Matrix3 m = Vector3(-1, 1, 1).asDiagonal();
    return m * i * m;
  };
  return r;
}

Restatement boosted(const Vector3& velocity) {
  Restatement r;
  r.boost = velocity;
  return r;
}

Restatement heavier(double factor) {
  Restatement r;
  r.mass = factor;
  return r;
}

// q' = q c, I' = C^T I C, anchors C^T a.
Restatement other_body_axes(const Quaternion& c) {
  Restatement r;
  r.own = [=](const Vector3& a) -> Vector3 { return c.conjugate() * a; };
  r.orientation = [=](const Quaternion& q) { return q * c; };
  r.inertia = [=](const Matrix3& i) -> Matrix3 {
    const Matrix3 m = c.toRotationMatrix(), other = m.transpose() * i * m;
    return (other + other.transpose()) / 2;
  };
  return r;
}

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
