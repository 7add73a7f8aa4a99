// Joints as rows of velocities, for what begins a scene anew: poses and velocities that fit the joints.
// Knows no engine and no protocol.
#pragma once

#include "harness/core/scene.h"

#include <vector>

namespace cylon::process {

/// A joint as its bodies carry it.
struct HeldJoint {
  core::JointType type = core::JointType::ball;
  int body = 0;
  int to = core::world;
  core::Vector3 anchor = core::Vector3::Zero();     ///< Axes of `body` [m].
  core::Vector3 to_anchor = core::Vector3::Zero();  ///< Axes of `to`, or a point of the world [m].
  core::Vector3 axis = core::Vector3::UnitY();      ///< Of a hinge, axes of `body`.
  core::Vector3 to_axis = core::Vector3::UnitY();   ///< Of a hinge, axes of `to`, or of the world.
  core::Quaternion turn =
      core::Quaternion::Identity();  ///< Axes of `body` in those of `to`, of a fixed joint.
  double length = 0;                 ///< Of a distance joint [m].
};

/// The scene's joints as they hold its initial state.
std::vector<HeldJoint> held_joints(const core::Scene&);

/// The joint of a scene that holds `state` as `held` does: its point and its axis as they are now.
core::Joint joint_at(const HeldJoint&, const core::State&);

/// Takes gaps away, by the shortest way in the metric of the masses; at most ten Newton steps, each of which
/// leaves the square of what was left.  Then fit_velocities.
void fit(const core::Scene&, const std::vector<HeldJoint>&, core::State&);

/// Velocities that the joints allow, by impulses of the joints alone:
///   v+ = v - M^-1 J^T (J M^-1 J^T)^+ J v
/// so that momentum changes by what the joints give, and the world's joints take what is missing.
void fit_velocities(const core::Scene&, const std::vector<HeldJoint>&, core::State&);

/// An impulse [N s], world axes, at the centre of mass of a body that is not locked: v += J/m, then the
/// joints' answer.
void kick(const core::Scene&, const std::vector<HeldJoint>&, core::State&, int body,
          const core::Vector3& impulse);

}  // namespace cylon::process
