// The trees of bodies that joints make, as btMultiBody has them; knows no Bullet header.
#pragma once

#include "harness/core/joint_coordinates.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::simulators {

/// The place of a body in the tree that its joints make.
struct TreePlace {
  int joint = -1;   ///< Through which it hangs on its parent, of the scene's joints; -1: a free base.
  int parent = -1;  ///< A body; the world where there is none.
};

/// The bodies that joints connect with `first`, parents before children.  The root hangs from the world by
/// the first joint that does, else it is free and the first body by index.
struct Tree {
  std::vector<int> bodies;
  std::vector<TreePlace> places;  ///< In the same order.
  std::vector<int> loops;         ///< Joints that close a loop.
};
Tree tree_of(const core::Scene&, int first);

/// Whether each moving body hangs from the world by joints without loops, or is alone and without gyroscopic
/// torque: what btMultiBody's Runge-Kutta 4 integrates to its order.  Of a free base it takes the
/// orientation of the step's beginning in all four stages.
bool all_hung(const core::Scene&);

/// Whether joints close a loop.
bool has_loops(const core::Scene&);

/// Why the joints of a scene, of kinds that Bullet has, cannot be expressed by btMultiBody, or nothing.
std::optional<std::string> untreelike(const core::Scene&);

/// Whether a body is the world or does not move.
bool still(const core::Scene&, int body);

/// Whether limits or dry friction act along a coordinate of the joint.
bool resisted(const core::Joint&);

/// What acts along the one coordinate of a hinge or a slider.
core::JointCoordinate coordinate_of(const core::Joint&);

}  // namespace cylon::simulators
