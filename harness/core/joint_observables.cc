#include "harness/core/joint_observables.h"

#include "harness/core/joint_coordinates.h"

#include <algorithm>

namespace cylon::core {
namespace {

bool of_displacements(Quantity q) {
  return q == Quantity::joint_displacement || q == Quantity::joint_displacement_rate;
}

// Whether the kind of joint leaves such a coordinate free.
bool has_one(const Observable& q, const Joint& joint) {
  const JointKind& kind = kind_of(joint.type);
  const int count = of_displacements(q.quantity) ? kind.displacements() : kind.angles();
  return count > static_cast<int>(q.which);
}

template <class Use>
void each_joint(const Observable& q, const Scene& scene, Use use) {
  for (std::size_t j = 0; j < scene.joints.size(); ++j)
    if ((!q.joint || static_cast<std::size_t>(*q.joint) == j) && has_one(q, scene.joints[j]))
      use(held_joint(scene, scene.joints[j]));
}

// The value that the scene gives the coordinate at t = 0; 0 where it says nothing of it.
double start_of(const HeldJoint& joint, Quantity quantity, Ordinal which) {
  double start = 0;
  const auto look = [&](const JointCoordinate& c) {
    if (c.which == which) start = c.start;
  };
  if (of_displacements(quantity))
    std::ranges::for_each(joint.displacements, look);
  else
    std::ranges::for_each(joint.angles, look);
  return start;
}

double value_of(const HeldJoint& joint, const Observable& q, const State& state) {
  switch (q.quantity) {
    case Quantity::joint_displacement:
      return start_of(joint, q.quantity, q.which) + joint_displacement(joint, q.which, state);
    case Quantity::joint_displacement_rate:
      return joint_displacement_rate(joint, q.which, state);
    case Quantity::joint_angle:
      return start_of(joint, q.quantity, q.which) + joint_angle(joint, q.which, state);
    default:
      return joint_angle_rate(joint, q.which, state);
  }
}

Vector3 spin_of(const State& state, int body) {
  return body == world ? Vector3(Vector3::Zero()) : state[static_cast<std::size_t>(body)].angular_velocity;
}

}  // namespace

std::optional<std::string> joint_value_undefined(const Observable& q, const Scene& scene) {
  bool found = false;
  each_joint(q, scene, [&](const HeldJoint&) { found = true; });
  if (found) return std::nullopt;
  return q.joint ? "the joint leaves no such coordinate free"
                 : "no joint of the scene leaves such a coordinate free";
}

void joint_values(const Observable& q, const Scene& scene, const State& state, Values& values) {
  each_joint(q, scene,
             [&](const HeldJoint& joint) { values.emplace_back(value_of(joint, q, state), 0, 0, 0); });
}

// With s the distance from the one centre to the point on it, and from the other to the same point:
//   |d(n.d)| <= 2 |dx| + 2 s |dtheta|
//   of a gimbal's angles with s' = 1/sin of the angle between its axes:  |dq| <= 2 s' |dtheta|,
//   |dq'| <= 2 s' |dw| + 8 s'^2 (|w_a| + |w_b|) |dtheta|
//   |d(n.d)'| <= 2 |dv| + 2 s |dw| + (|v_a - v_b| + 2 s (|w_a| + |w_b|)) 2 |dtheta| + (|w_a| + |w_b|) 2 |dx|
double joint_value_error(const Observable& q, const Scene& scene, const State& state, const StateError& e) {
  double most = 0;
  each_joint(q, scene, [&](const HeldJoint& joint) {
    const double arm = joint.anchor.norm() + (joint.to == world ? 0 : joint.to_anchor.norm());
    Observable along = q;
    along.quantity = Quantity::joint_displacement;
    const double s = arm + (of_displacements(q.quantity) ? std::abs(value_of(joint, along, state)) : 0);
    const double spins = spin_of(state, joint.body).norm() + spin_of(state, joint.to).norm();
    const double sharp = angle_sharpness(joint, state);
    double error = 0;
    switch (q.quantity) {
      case Quantity::joint_displacement:
        error = 2 * e.position + 2 * s * e.orientation;
        break;
      case Quantity::joint_displacement_rate: {
        const auto velocity = [&](int body) {
          return body == world ? Vector3(Vector3::Zero()) : state[static_cast<std::size_t>(body)].velocity;
        };
        const double speed = (velocity(joint.body) - velocity(joint.to)).norm();
        error = 2 * e.velocity + 2 * s * e.angular_velocity + 2 * (speed + 2 * s * spins) * e.orientation +
                2 * spins * e.position;
        break;
      }
      case Quantity::joint_angle:
        error = 2 * sharp * e.orientation;
        break;
      default:
        error = 2 * sharp * e.angular_velocity + (sharp == 1 ? 2 : 8 * sharp * sharp) * spins * e.orientation;
    }
    most = std::max(most, error);
  });
  return most;
}

}  // namespace cylon::core
