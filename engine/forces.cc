#include "engine/forces.h"

#include <cmath>

namespace cylon::engine {

namespace {

// A body's anchor: its arm from the centre of mass, where it is, and how fast it moves; seed eq. 65, 66 with
// the arm rotated (errata 14).
struct End {
  Vector3 arm = Vector3::Zero(), place, velocity = Vector3::Zero();
};

End end_of(int body, const Vector3& anchor, const std::vector<Motion>& motion,
           const std::vector<Rate>& rate) {
  if (body == fixed_world) return {.place = anchor};
  const auto i = static_cast<std::size_t>(body);
  if (anchor.isZero(0)) return {.place = motion[i].position, .velocity = rate[i].velocity};
  const Vector3 r = motion[i].orientation * anchor;
  return {r, motion[i].position + r, rate[i].velocity + rate[i].angular_velocity.cross(r)};
}

void push(int body, const Vector3& arm, const Vector3& force, std::vector<Rate>& rate) {
  if (body == fixed_world) return;
  rate[static_cast<std::size_t>(body)].force += force;
  rate[static_cast<std::size_t>(body)].torque += arm.cross(force);
}

void apply(const Spring& spring, const std::vector<Motion>& motion, std::vector<Rate>& rate) {
  const End a = end_of(spring.body, spring.anchor, motion, rate);
  const End b = end_of(spring.to, spring.to_anchor, motion, rate);

  const Vector3 d = b.place - a.place;
  Vector3 force = spring.stiffness * d;  // all of it where the rest length and the damping are zero
  if (spring.rest_length != 0 || spring.damping != 0) {
    const Real length = d.norm();
    if (length == 0) return;
    const Vector3 u = d / length;
    force =
        (spring.stiffness * (length - spring.rest_length) + spring.damping * u.dot(b.velocity - a.velocity)) *
        u;
  }
  push(spring.body, a.arm, force, rate);
  push(spring.to, b.arm, -force, rate);
}

void apply(const Drag& drag, const std::vector<Motion>& motion, std::vector<Rate>& rate) {
  const auto i = static_cast<std::size_t>(drag.body);
  rate[i].force -= drag.linear * rate[i].velocity;
  rate[i].torque -= drag.angular * rate[i].angular_velocity + drag.momentum * motion[i].angular_momentum;
}

void apply(const Drive& drive, Real time, std::vector<Rate>& rate) {
  rate[static_cast<std::size_t>(drive.body)].force += drive.force * std::cos(drive.frequency * time);
}

}  // namespace

void apply(const Forces& forces, Real time, const std::vector<Body>& bodies,
           const std::vector<Motion>& motion, std::vector<Rate>& rate) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    rate[i].force = bodies[i].mass * forces.gravity;
    rate[i].torque.setZero();
  }
  for (const Spring& spring : forces.springs) apply(spring, motion, rate);
  for (const Drag& drag : forces.drags) apply(drag, motion, rate);
  for (const Drive& drive : forces.drives) apply(drive, time, rate);
}

}  // namespace cylon::engine
