#include "reference/applied/joint_forces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cylon::applied {
namespace {

using core::Ordinal;
using core::Quaternion;
using core::Vector3;

Quaternion orientation(const core::State& state, int body) {
  return body == core::world ? Quaternion(Quaternion::Identity())
                             : state[static_cast<std::size_t>(body)].orientation;
}

double law(const core::JointCoordinate& c, double t, double q, double rate) {
  return c.force - c.stiffness * (q - core::target(c, t)) - c.damping * (rate - core::target_rate(c, t)) -
         c.quadratic_damping * rate * std::abs(rate);
}

// A force through a point, world axes.
void push(std::vector<Wrench>& wrenches, const core::State& state, int body, const Vector3& point,
          const Vector3& force) {
  if (body == core::world) return;
  const auto i = static_cast<std::size_t>(body);
  wrenches[i].force += force;
  wrenches[i].torque += (point - state[i].position).cross(force);
}

void twist(std::vector<Wrench>& wrenches, int body, const Vector3& torque) {
  if (body != core::world) wrenches[static_cast<std::size_t>(body)].torque += torque;
}

// The direction of a displacement, axes of `to`.
Vector3 direction(const core::HeldJoint& joint, Ordinal which) {
  if (!core::kind_of(joint.type).has_second_axis()) return joint.to_axis;
  return which == Ordinal::first ? joint.to_axis_2 : Vector3(joint.to_axis.cross(joint.to_axis_2));
}

}  // namespace

JointForces::JointForces(const core::Scene& scene) {
  for (const core::HeldJoint& joint : core::held_joints(scene)) {
    Acting acting{joint, {}};
    const auto idle = [](const core::JointCoordinate& c) { return !core::has_force(c); };
    std::erase_if(acting.joint.displacements, idle);
    std::erase_if(acting.joint.angles, idle);
    acting.angles.resize(acting.joint.angles.size(), 0.0);
    if (!acting.joint.displacements.empty() || !acting.angles.empty()) joints_.push_back(std::move(acting));
  }
}

void JointForces::add(double t, const core::State& state, std::vector<Wrench>& wrenches) {
  for (Acting& acting : joints_) {
    const core::HeldJoint& joint = acting.joint;
    const Quaternion ours = orientation(state, joint.body), theirs = orientation(state, joint.to);
    for (const core::JointDisplacement& c : joint.displacements) {
      const double q = c.start + core::joint_displacement(joint, c.which, state),
                   rate = core::joint_displacement_rate(joint, c.which, state);
      const Vector3 force = law(c, t, q, rate) * (theirs * direction(joint, c.which));
      // Both at the point of `body`, so that the power is Q q'.
      const Vector3 point =
          joint.body == core::world
              ? joint.anchor
              : Vector3(state[static_cast<std::size_t>(joint.body)].position + ours * joint.anchor);
      push(wrenches, state, joint.body, point, force);
      push(wrenches, state, joint.to, point, -force);
    }
    for (std::size_t k = 0; k < joint.angles.size(); ++k) {
      const core::JointAngle& c = joint.angles[k];
      double& angle = acting.angles[k];
      angle += std::remainder(core::joint_angle(joint, c.which, state) - angle, 2 * std::numbers::pi);
      const Vector3 torque = law(c, t, c.start + angle, core::joint_angle_rate(joint, c.which, state)) *
                             core::angle_direction(joint, c.which, state);
      twist(wrenches, joint.body, torque);
      twist(wrenches, joint.to, -torque);
    }
  }
}

}  // namespace cylon::applied
