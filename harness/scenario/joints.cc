// Joints, and initial velocities that they allow.
#include "harness/core/held_joint.h"
#include "harness/scenario/read_element.h"

#include <fmt/format.h>

#include <cmath>

namespace cylon::scenario {
namespace {

using core::Vector3;

// Velocities are compared within this fraction of the speeds involved: what six typed digits leave.
constexpr double typed = 1e-6;

// Velocity of the point of a body (or of the world) that is at `point` now: v + w x (point - p).
Vector3 velocity_at(const core::Scene& scene, int body, const Vector3& point) {
  if (body == core::world) return Vector3::Zero();
  const core::BodyState& s = scene.bodies[static_cast<std::size_t>(body)].initial;
  return s.velocity + s.angular_velocity.cross(point - s.position);
}

Vector3 spin_of(const core::Scene& scene, int body) {
  return body == core::world ? Vector3::Zero()
                             : scene.bodies[static_cast<std::size_t>(body)].initial.angular_velocity;
}

void check_velocity(const Table& t, Draft& draft, const core::Joint& joint, const Vector3& from,
                    const Vector3& end) {
  core::BodyState& s = draft.scene.bodies[static_cast<std::size_t>(joint.body)].initial;
  const Table& origin = draft.origin[static_cast<std::size_t>(joint.body)];
  const core::JointKind& kind = core::kind_of(joint.type);
  const Vector3 excess = core::forbidden_velocity(
      kind.place, end - from,
      velocity_at(draft.scene, joint.body, from) - velocity_at(draft.scene, joint.to, end));
  const double speeds = s.velocity.norm() + s.angular_velocity.norm() * (from - s.position).norm() +
                        velocity_at(draft.scene, joint.to, end).norm();
  const Vector3 consistent = s.velocity - excess;
  if (excess.norm() > typed * speeds)
    origin.fail("velocity", fmt::format("velocity = {} breaks the {} joint of '{}' by {} m/s; consistent: {}",
                                        written(s.velocity), t.text("type"), t.text("body"), excess.norm(),
                                        written(consistent)));
  // Digits that were not typed: the joint of one body with the world decides them.
  if (joint.to == core::world && excess.norm() > 1e-12 * speeds) s.velocity = consistent;

  const Vector3 turning = s.angular_velocity - spin_of(draft.scene, joint.to);
  const Vector3 twist = core::forbidden_spin(kind.turn, joint.axis, turning);
  if (twist.norm() > typed * (s.angular_velocity.norm() + spin_of(draft.scene, joint.to).norm()))
    origin.fail("angular_velocity",
                fmt::format("angular_velocity = {} breaks the {} joint of '{}' by {} rad/s; consistent: {}",
                            written(s.angular_velocity), t.text("type"), t.text("body"), twist.norm(),
                            written(s.angular_velocity - twist)));
}

core::Joint read_joint(const Table& t, Draft& draft) {
  auto joint = read_element<core::Joint>(t, draft);
  if (joint.to == joint.body) t.fail("to", "a joint joins two different bodies, or one with the world");
  const core::JointKind& kind = core::kind_of(joint.type);
  const bool distance = kind.joins_centres();
  if (distance && t.has("point") && t.has("to"))
    t.fail("point", "point: a distance between two bodies joins their centres");
  if (distance && !t.has("point") && !t.has("to"))
    t.fail("a distance joint needs 'to' (a body) or 'point' (of the world)");
  if (kind.has_axis()) {
    if (!(joint.axis.cwiseAbs().maxCoeff() > 0)) t.fail("axis", "axis = [0, 0, 0] has no direction");
    make_unit(joint.axis);
  }

  const auto& bodies = draft.scene.bodies;
  Vector3 from = joint.point, end = joint.point;
  if (distance) {
    from = bodies[static_cast<std::size_t>(joint.body)].initial.position;
    if (joint.to != core::world) end = bodies[static_cast<std::size_t>(joint.to)].initial.position;
    const double apart = (end - from).norm();
    if (!(apart > 0)) t.fail("a distance joint needs its two ends apart, but both start at " + written(from));
    joint.length = t.number("length", apart);
    if (std::abs(joint.length - apart) > 1e-9 * apart)
      t.fail("length", fmt::format("length = {}, but the ends start {} m apart", joint.length, apart));
  }
  check_velocity(t, draft, joint, from, end);
  return joint;
}

}  // namespace

void read_joints(const Table& root, Draft& draft) {
  for (const Table& t : root.tables("joint")) draft.scene.joints.push_back(read_joint(t, draft));
}

}  // namespace cylon::scenario
