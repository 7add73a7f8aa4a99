// What a joint keeps, as geometry: where its bodies carry it, how far it is open, what it forbids.
// Knows no engine.
#pragma once

#include "harness/core/scene.h"

#include <string>
#include <vector>

namespace cylon::core {

/// A joint as its bodies carry it.
struct HeldJoint {
  JointType type = JointType::ball;
  int body = 0;
  int to = world;
  Vector3 anchor = Vector3::Zero();          ///< Axes of `body` [m].
  Vector3 to_anchor = Vector3::Zero();       ///< Axes of `to`, or a point of the world [m].
  Vector3 axis = Vector3::UnitY();           ///< Axes of `body`.
  Vector3 to_axis = Vector3::UnitY();        ///< Axes of `to`, or of the world.
  Quaternion turn = Quaternion::Identity();  ///< At t = 0: axes of `body` in those of `to`.
  double length = 0;                         ///< [m]
  Vector3 axis_2 = Vector3::UnitX();         ///< Axes of `body`.
  Vector3 to_axis_2 = Vector3::UnitX();      ///< Axes of `to`, or of the world.
  double pitch = 0;                          ///< [m/rad]
  std::string name = {};
  std::vector<JointDisplacement> displacements = {};  ///< As the scene states them.
  std::vector<JointAngle> angles = {};
};

/// The scene's joints as they hold its initial state.
std::vector<HeldJoint> held_joints(const Scene&);
/// One of them.
HeldJoint held_joint(const Scene&, const Joint&);

/// J v = d.v_a + s_a.w_a - d.v_b - s_b.w_b = 0, and the gap that it changes.
struct JointRow {
  int body, to;
  Vector3 direction, spin, to_spin;  ///< d, s_a, s_b: world axes.
  double gap;                        ///< [m] or [rad]
  double scale;                      ///< Of the numbers whose difference the gap is.
};

/// Adds the rows of a joint: what its place keeps, then what its turn does, then that it screws.
void add_rows(const HeldJoint&, const State&, std::vector<JointRow>&);

/// Where a joint of the scene holds `body` at t = 0, world coordinates [m]: its point, but of one with an offset.
Vector3 held_point_of_body(const Joint&);

/// How far a joint of the scene is open [m]: distance of the two points, what it is off its length by, or of the one
/// point from the line or the plane that the other carries; of a screw also what its displacement is off by.
double open_by(const Scene&, const Joint&, const State&);

/// How far the bodies of a joint of the scene are turned against each other as it forbids [rad]: the angle
/// between its axis in the one and in the other, what its two axes are off a right angle by, or that of their relative
/// turn since t = 0; 0 for a joint that lets them turn freely.
double turned_by(const Scene&, const Joint&, const State&);

/// How two bodies move against each other at a joint.
struct RelativeMotion {
  Vector3 velocity = Vector3::Zero();  ///< Of the point on `body` less that of the point on `to` [m/s].
  Vector3 spin = Vector3::Zero();      ///< [rad/s]
};

/// The part of a motion at t = 0 that a joint forbids; `apart` [m] from the point on `to` to that on `body`.  Of a joint with
/// an offset, both velocities are at the point on `body`.
RelativeMotion forbidden(const Joint&, const Vector3& apart, const RelativeMotion&);

}  // namespace cylon::core
