#include "engine/dynamics.h"

#include <algorithm>
#include <utility>

namespace cylon::engine {

Dynamics::Dynamics(Model model, const std::vector<Motion>& motion)
    : bodies(std::move(model.bodies)),
      forces(std::move(model.forces)),
      joints(std::move(model.joints)),
      contacts(std::move(model.contacts)),
      any_locked_(std::any_of(bodies.begin(), bodies.end(), [](const Body& body) { return body.locked; })),
      constrained_(!joints.empty() || !contacts.empty()),
      pressed_(contacts.size(), 0) {
  rows_.rows.reserve(3 * joints.size() + contacts.size());
  find_turning(motion);
}

// A body turns if it has spin, or if an off-centre spring or a joint can give it some; drag takes it and
// impacts between frictionless spheres leave it.
void Dynamics::find_turning(const std::vector<Motion>& motion) {
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].turns = !motion[i].angular_momentum.isZero(0);
  const auto held_at = [&](int body, const Vector3& anchor) {
    if (body != fixed_world && !anchor.isZero(0)) bodies[static_cast<std::size_t>(body)].turns = true;
  };
  for (const Spring& spring : forces.springs) {
    held_at(spring.body, spring.anchor);
    held_at(spring.to, spring.to_anchor);
  }
  for (const BallJoint& joint : joints) {
    held_at(joint.body, joint.anchor);
    held_at(joint.to, joint.to_anchor);
  }
}

void Dynamics::rates(Real time, const std::vector<Motion>& motion, std::vector<Rate>& rate) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    rate[i].velocity = velocity(bodies[i], motion[i]);
    rate[i].angular_velocity =
        bodies[i].turns ? angular_velocity(bodies[i], motion[i]) : Vector3(Vector3::Zero());
  }
  apply(forces, time, bodies, motion, rate);
  if (constrained_) constrain(motion, rate);
  if (!any_locked_) return;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].locked) rate[i].force.setZero(), rate[i].torque.setZero();
  }
}

void Dynamics::constrain(const std::vector<Motion>& motion, std::vector<Rate>& rate) {
  gather(motion, false);
  rows_.constrain_accelerations(bodies, motion, rate);
  std::size_t row = 3 * joints.size();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    pressed_[i] = contacts[i].resting && rows_.rows[row++].lambda > 0;
  }
}

void Dynamics::project(std::vector<Motion>& motion) {
  if (!constrained_) return;
  constexpr int sweeps = 3;  // of Newton's method: each leaves the square of a drift that is small already
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    gather(motion, true);
    if (rows_.closed()) break;
    rows_.project_positions(bodies, motion);
  }
  if (!rows_.rows.empty()) rows_.project_velocities(bodies, motion);
}

void Dynamics::gather(const std::vector<Motion>& motion, bool pressed_only) {
  rows_.rows.clear();
  for (const BallJoint& joint : joints) add_rows(joint, bodies, motion, rows_.rows);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].resting && (pressed_[i] || !pressed_only))
      add_rows(contacts[i], bodies, motion, rows_.rows);
  }
}

}  // namespace cylon::engine
