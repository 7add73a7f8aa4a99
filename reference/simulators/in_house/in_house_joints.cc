#include "reference/simulators/in_house/in_house_joints.h"

#include "harness/core/held_joint.h"
#include "reference/simulators/in_house/in_house_real.h"

#include <cmath>
#include <utility>

namespace cylon::simulators {
namespace {

using core::HeldJoint;
using core::Ordinal;
using engine::Coordinate;
using engine::Joint;
using engine::Real;

Joint::Place place_of(core::JointPlace place) {
  switch (place) {
    case core::JointPlace::together:
      break;
    case core::JointPlace::at_length:
      return Joint::Place::at_length;
    case core::JointPlace::along_axis:
      return Joint::Place::along_axis;
    case core::JointPlace::in_plane:
      return Joint::Place::in_plane;
    case core::JointPlace::along_normal:
      return Joint::Place::along_normal;
  }
  return Joint::Place::together;
}

Joint::Turn turn_of(core::JointTurn turn) {
  switch (turn) {
    case core::JointTurn::freely:
      break;
    case core::JointTurn::about_axis:
      return Joint::Turn::about_axis;
    case core::JointTurn::never:
      return Joint::Turn::never;
    case core::JointTurn::about_two_axes:
      return Joint::Turn::about_two_axes;
    case core::JointTurn::about_three_axes:
      return Joint::Turn::about_three_axes;
  }
  return Joint::Turn::freely;
}

// Of two axes the first is carried by `to`, the second by `body`.  A gimbal on whose angles nothing acts is a ball, and has no
// turn that it cannot pass.
Joint joint_of(const HeldJoint& held) {
  const core::JointKind& kind = core::kind_of(held.type);
  const bool two = kind.turns_between_axes();
  const bool counts = !kind.turns_freely() || !held.angles.empty();
  return {.type = {place_of(kind.place), counts ? turn_of(kind.turn) : Joint::Turn::freely, kind.screws},
          .body = held.body,
          .anchor = real(held.anchor),
          .to = held.to,
          .to_anchor = real(held.to_anchor),
          .axis = real(two ? held.axis_2 : held.axis),
          .to_axis = real(held.to_axis),
          .relative = real(held.turn),
          .length = real(held.length),
          .pitch = real(held.pitch)};
}

// ---- Coordinates ---------------------------------------------------------------------------------

Coordinate between(const HeldJoint& held, Coordinate::Kind kind, double start) {
  Coordinate q;
  q.kind = kind;
  q.body = held.body, q.anchor = real(held.anchor);
  q.to = held.to, q.to_anchor = real(held.to_anchor);
  q.origin = real(start);
  return q;
}

Coordinate coordinate_of(const HeldJoint& held, const core::JointDisplacement& displacement) {
  Coordinate q = between(held, Coordinate::Kind::displacement, displacement.start);
  const bool in_plane = core::kind_of(held.type).place == core::JointPlace::in_plane;
  const core::Vector3 first = in_plane ? held.to_axis_2 : held.to_axis;
  q.axis = real(displacement.which == Ordinal::first ? first : core::Vector3(held.to_axis.cross(first)));
  return q;
}

// Counted from t = 0.  The second angle of two or three is about the axis that `body` carries, the third of a gimbal is that
// between the axes.
Coordinate coordinate_of(const HeldJoint& held, const core::JointAngle& angle) {
  const core::JointKind& kind = core::kind_of(held.type);
  const bool three = kind.turn == core::JointTurn::about_three_axes;
  Coordinate q = between(held, three ? Coordinate::Kind::azimuth : Coordinate::Kind::angle, angle.start);
  const auto square_part = [](const core::Vector3& v, const core::Vector3& axis) {
    return core::Vector3((v - axis.dot(v) * axis).normalized());
  };
  q.on_body = angle.which == Ordinal::second;
  if (q.on_body) {
    q.axis = real(held.axis_2), q.mark = real(held.to_axis);
    q.zero = real(three ? square_part(held.axis, held.axis_2) : held.axis);
    return q;
  }
  if (three) {
    q.axis = real(held.to_axis), q.mark = real(held.axis_2);
    q.zero = real(square_part(held.to_axis_2, held.to_axis));
    if (angle.which == Ordinal::first) return q;
    q.kind = Coordinate::Kind::inclination;
    q.zero_inclination =
        std::atan2(q.axis.cross(real(held.to_axis_2)).norm(), q.axis.dot(real(held.to_axis_2)));
    return q;
  }
  const bool two = kind.turns_between_axes();
  const core::Vector3 zero = two ? held.to_axis_2 : core::Vector3(held.to_axis.unitOrthogonal());
  q.axis = real(held.to_axis), q.zero = real(zero);
  q.mark = real(core::Vector3(held.turn.conjugate() * zero));
  return q;
}

template <class Stated>
void add_law(const HeldJoint& held, const Stated& stated, engine::Model& model) {
  engine::CoordinateLaw law;
  law.at = coordinate_of(held, stated);
  law.stiffness = real(stated.stiffness), law.damping = real(stated.damping);
  law.quadratic_damping = real(stated.quadratic_damping), law.force = real(stated.force);
  law.friction = real(stated.friction), law.restitution = real(stated.restitution);
  law.armature = real(stated.armature);
  if (stated.lower) law.lower = real(*stated.lower);
  if (stated.upper) law.upper = real(*stated.upper);
  law.target.value = real(stated.target), law.target.amplitude = real(stated.target_amplitude);
  law.target.frequency = real(stated.target_frequency), law.target.phase = real(stated.target_phase);
  law.target.times.assign(stated.target_times.begin(), stated.target_times.end());
  for (const double value : stated.target_values) law.target.values.push_back(real(value));
  model.forces.coordinate_laws.push_back(std::move(law));
}

}  // namespace

void add_joints(const core::Scene& scene, engine::Model& model) {
  for (const HeldJoint& held : core::held_joints(scene)) {
    model.joints.push_back(joint_of(held));
    for (const core::JointDisplacement& stated : held.displacements) add_law(held, stated, model);
    for (const core::JointAngle& stated : held.angles) add_law(held, stated, model);
  }
}

}  // namespace cylon::simulators
