#include "harness/study/restate.h"

#include "harness/core/overloaded.h"

#include <utility>

namespace cylon::study {
namespace {

using core::Matrix3;
using core::Vector3;

// Of an orthogonal M: pseudovectors go with det(M) M.
Matrix3 pseudo(const Matrix3& m) { return m.determinant() * m; }

}  // namespace

Vector3 Restatement::place(const Vector3& p) const { return length * (turn * p + move); }

Vector3 Restatement::anchor(int body, const Vector3& a) const {
  return body == core::world ? place(a) : length * (own * a);
}

// x' = turn x + move, v' = turn v, w' = det(turn) turn w, R' = turn R own^T; then the units.
core::BodyState Restatement::operator()(const core::BodyState& s) const {
  core::BodyState result;
  result.position = place(s.position);
  // R' from quaternions where both are rotations (to rounding), from matrices where both are mirrors.
  result.orientation =
      core::Quaternion(pseudo(turn)) * s.orientation * core::Quaternion(Matrix3(pseudo(own).transpose()));
  result.velocity = length / time * (turn * s.velocity);
  result.angular_velocity = pseudo(turn) * s.angular_velocity / time;
  return result;
}

core::State Restatement::operator()(core::State state) const {
  for (core::BodyState& s : state) s = (*this)(s);
  return state;
}

core::Primitive Restatement::shape(core::Primitive primitive) const {
  const bool mirrored = own.determinant() < 0;
  std::visit(core::Overloaded{
                 [](std::monostate&) {},
                 [&](core::Sphere& s) { s.radius *= length; },
                 [&](core::Box& s) { s.half_extents *= length; },
                 [&](core::Rod& s) { s.length *= length; },
                 [&](core::Disc& s) { s.radius *= length; },
                 [&](core::Hull& s) {
                   for (Vector3& v : s.vertices) v = length * (own * v);
                 },
                 [&](core::Mesh& s) {
                   for (Vector3& v : s.vertices) v = length * (own * v);
                   for (auto& face : s.faces)
                     if (mirrored) std::swap(face[1], face[2]);  // counter-clockwise from outside again
                 },
                 [&](auto& s) { s.radius *= length, s.length *= length; },
             },
             primitive);
  return primitive;
}

core::Scene Restatement::operator()(core::Scene scene) const {
  const double speed = length / time, force = mass * speed / time;
  for (core::Body& b : scene.bodies) {
    b.initial = (*this)(b.initial);
    b.mass *= mass;
    const Matrix3 inertia = mass * length * length * (own * b.inertia * own.transpose());
    b.inertia = (inertia + inertia.transpose()) / 2;
    if (auto* compound = std::get_if<core::Compound>(&b.shape)) {
      for (core::Part& part : compound->parts) {
        part.shape = shape(part.shape);
        part.mass *= mass;
        part.position = length * (own * part.position);
        // A part is mirrored in its own axes too: own P own^T.
        part.orientation = core::Quaternion(pseudo(own)) * part.orientation *
                           core::Quaternion(Matrix3(pseudo(own).transpose()));
      }
    } else {
      b.shape = std::visit(core::Overloaded{[](const core::Compound&) -> core::Shape { return {}; },
                                            [&](const auto& s) -> core::Shape {
                                              return std::visit([](auto t) -> core::Shape { return t; },
                                                                shape(core::Primitive(s)));
                                            }},
                           b.shape);
    }
  }
  for (core::Force& f : scene.forces)
    std::visit(core::Overloaded{
                   [&](core::UniformGravity& g) { g.acceleration = speed / time * (turn * g.acceleration); },
                   [&](core::Spring& k) {
                     k.anchor = anchor(k.body, k.anchor);
                     k.to_anchor = anchor(k.to, k.to_anchor);
                     k.stiffness *= mass / (time * time);
                     k.rest_length *= length;
                     k.damping *= mass / time;
                   },
                   [&](core::Drag& d) {
                     d.linear *= mass / time;
                     d.angular *= mass * length * length / time;
                     d.momentum /= time;
                   },
                   [&](core::Thrust& t) {
                     t.force = force * (own * t.force);
                     t.mass_rate *= mass / time;
                     if (t.exhaust_velocity) t.exhaust_velocity = speed * (own * *t.exhaust_velocity);
                     if (t.exchanged_velocity) t.exchanged_velocity = speed * (turn * *t.exchanged_velocity);
                   },
                   [&](core::Drive& d) {
                     d.force = force * (turn * d.force);
                     d.frequency /= time;
                   },
                   [&](core::Attraction& a) { a.strength *= length * speed * speed / mass; },
                   [](core::Water&) {},
               },
               f);
  for (core::Joint& j : scene.joints) {
    j.point = place(j.point);
    j.axis = turn * j.axis;
    j.length *= length;
  }
  for (core::Plane& p : scene.planes) {
    p.normal = turn * p.normal;
    p.offset = length * (p.offset + p.normal.dot(move));
  }
  if (scene.frame) {
    scene.frame->velocity = speed * (turn * scene.frame->velocity);
    scene.frame->angular_velocity = pseudo(turn) * scene.frame->angular_velocity / time;
  }
  return scene;
}

}  // namespace cylon::study
