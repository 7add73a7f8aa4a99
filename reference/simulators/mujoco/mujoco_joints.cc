#include "reference/simulators/mujoco/mujoco_joints.h"

#include <algorithm>

namespace cylon::simulators {
namespace {

using core::Joint;
using core::Ordinal;
using core::Vector3;

template <class Coordinate>
core::JointCoordinate acting(const std::vector<Coordinate>& list, Ordinal which) {
  const auto found = std::ranges::find(list, which, &core::JointCoordinate::which);
  return found == list.end() ? core::JointCoordinate{.which = which} : core::JointCoordinate(*found);
}

}  // namespace

// Displacements first: their axes are those of the parent.  Of a universal joint R(axis, first) R(axis_2, second), and
// from the other side R(axis_2, -second) R(axis, -first); of a gimbal with R(axis x axis_2, third) between the two.  Those of a
// universal joint with an offset are each through the point of who carries it.
std::vector<MujocoAxis> mujoco_axes(const core::Scene& scene, const Joint& joint, bool reversed) {
  const core::JointKind& kind = core::kind_of(joint.type);
  const core::HeldJoint held = core::held_joint(scene, joint);
  const core::State start = core::initial_state(scene);
  const Vector3 second = joint.axis_2.value_or(joint.axis);
  std::vector<MujocoAxis> axes;
  const auto add = [&](bool slides, Ordinal which, const Vector3& axis) {
    MujocoAxis one{slides,
                   which,
                   axis,
                   slides ? acting(joint.displacements, which) : acting(joint.angles, which),
                   slides ? core::joint_displacement_rate(held, which, start)
                          : core::joint_angle_rate(held, which, start),
                   which == Ordinal::second ? core::held_point_of_body(joint) : joint.point};
    if (reversed) core::reverse(one.acts), one.rate = -one.rate;
    axes.push_back(one);
  };
  for (int k = 0; k < kind.displacements(); ++k) {
    const bool along = !kind.has_second_axis();
    add(true, k == 0 ? Ordinal::first : Ordinal::second,
        along    ? joint.axis
        : k == 0 ? second
                 : Vector3(joint.axis.cross(second)));
  }
  if (kind.turn == core::JointTurn::about_axis) add(false, Ordinal::first, joint.axis);
  if (kind.turns_between_axes()) {
    add(false, Ordinal::first, joint.axis);
    if (kind.turn == core::JointTurn::about_three_axes)
      add(false, Ordinal::third, joint.axis.cross(second).normalized());
    add(false, Ordinal::second, second);
    if (reversed) std::ranges::reverse(axes);
  }
  return axes;
}

}  // namespace cylon::simulators
