// A joint of a tree as MuJoCo's own joints: of one kind of coordinate each, in the order in which they act.  Knows no
// MuJoCo header.
#pragma once

#include "harness/core/joint_coordinates.h"

#include <vector>

namespace cylon::simulators {

/// One of MuJoCo's slides or hinges.
struct MujocoAxis {
  bool slides = false;
  core::Ordinal which = core::Ordinal::first;   ///< Of the scene's joint.
  core::Vector3 axis = core::Vector3::UnitX();  ///< World axes at t = 0.
  core::JointCoordinate acts;  ///< Of the scene's, counted as MuJoCo counts: of the child against its parent.
  double rate = 0;             ///< At t = 0, counted so.
  core::Vector3 point =
      core::Vector3::Zero();  ///< Through which the axis goes, world coordinates at t = 0 [m].
};

/// Of a joint that is no ball and not fixed, whose child is `body` of the joint or, `reversed`, its `to`.
std::vector<MujocoAxis> mujoco_axes(const core::Scene&, const core::Joint&, bool reversed);

}  // namespace cylon::simulators
