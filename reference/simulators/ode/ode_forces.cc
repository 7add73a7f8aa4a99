#include "reference/simulators/ode/ode_forces.h"

#include <ode/ode.h>

#include <cmath>

namespace cylon::simulators {
namespace {

using core::BodyState;
using core::Vector3;

Vector3 vector(const dReal* v) { return {v[0], v[1], v[2]}; }

// A scene's bodies as a force sees them.
struct Bodies {
  const core::Scene& scene;
  const std::vector<dBodyID>& ids;

  const core::Body& body(int i) const { return scene.bodies[static_cast<std::size_t>(i)]; }
  dBodyID id(int i) const { return i == core::world ? nullptr : ids[static_cast<std::size_t>(i)]; }
  BodyState state(int i) const { return ode_state(body(i), id(i)); }

  // The position and velocity of an anchor [body axes, or the world's].
  struct Point {
    Vector3 position, velocity;
  };
  Point point(int i, const Vector3& anchor) const {
    if (i == core::world) return {anchor, Vector3::Zero()};
    const BodyState s = state(i);
    const Vector3 arm = s.orientation * anchor;
    return {s.position + arm, s.velocity + s.angular_velocity.cross(arm)};
  }

  // Adds a force [N, world axes] at an anchor; locked bodies and the world do not feel it.
  void pull(int i, const Vector3& f, const Vector3& anchor = Vector3::Zero()) const {
    if (dBodyID b = id(i)) dBodyAddForceAtRelPos(b, f.x(), f.y(), f.z(), anchor.x(), anchor.y(), anchor.z());
  }
  void turn(int i, const Vector3& torque) const {
    if (dBodyID b = id(i)) dBodyAddTorque(b, torque.x(), torque.y(), torque.z());
  }
};

// F = (k (|d| - L) + c d(|d|)/dt) d/|d|
void add(const core::Spring& s, const Bodies& bodies, double) {
  const Bodies::Point p = bodies.point(s.body, s.anchor), q = bodies.point(s.to, s.to_anchor);
  const Vector3 d = q.position - p.position;
  const double length = d.norm();
  if (length == 0) return;
  const double rate = d.dot(q.velocity - p.velocity) / length;
  const Vector3 f = (s.stiffness * (length - s.rest_length) + s.damping * rate) / length * d;
  bodies.pull(s.body, f, s.anchor);
  bodies.pull(s.to, -f, s.to_anchor);
}

// F = -linear v; torque = -angular w - momentum I w
void add(const core::Drag& s, const Bodies& bodies, double) {
  const BodyState now = bodies.state(s.body);
  const Vector3 spin = core::world_inertia(bodies.body(s.body), now.orientation) * now.angular_velocity;
  bodies.pull(s.body, -s.linear * now.velocity);
  bodies.turn(s.body, -s.angular * now.angular_velocity - s.momentum * spin);
}

void add(const core::Thrust& s, const Bodies& bodies, double) {
  bodies.pull(s.body, bodies.state(s.body).orientation * s.force);
}

// F = force cos(frequency t)
void add(const core::Drive& s, const Bodies& bodies, double t) {
  bodies.pull(s.body, s.force * std::cos(s.frequency * t));
}

// F = strength m_a m_b d/|d|^3
void add(const core::Attraction& s, const Bodies& bodies, double) {
  const Vector3 d = bodies.state(s.to).position - bodies.state(s.body).position;
  const double r = d.norm();
  const Vector3 f = s.strength * bodies.body(s.body).mass * bodies.body(s.to).mass / (r * r * r) * d;
  bodies.pull(s.body, f);
  bodies.pull(s.to, -f);
}

void add(const core::UniformGravity&, const Bodies&, double) {}
void add(const core::Water&, const Bodies&, double) {}

}  // namespace

BodyState ode_state(const core::Body& body, dBodyID b) {
  if (!b) return {body.initial.position, body.initial.orientation, Vector3::Zero(), Vector3::Zero()};
  const dReal* q = dBodyGetQuaternion(b);
  return {vector(dBodyGetPosition(b)), core::Quaternion(q[0], q[1], q[2], q[3]), vector(dBodyGetLinearVel(b)),
          vector(dBodyGetAngularVel(b))};
}

void ode_apply(const core::Force& force, const core::Scene& scene, const std::vector<dBodyID>& bodies,
               double t) {
  std::visit([&](const auto& f) { add(f, Bodies{scene, bodies}, t); }, force);
}

}  // namespace cylon::simulators
