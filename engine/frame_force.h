// A scene given in a frame that turns or accelerates, with motions as the frame sees them: what the frame's own motion
// does to them is a force like others, so that contacts, joints to the world and drag are those of an inertial frame.
#pragma once

#include "engine/body.h"
#include "engine/ends.h"
#include "engine/features.h"
#include "engine/numbering.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace cylon::engine {

/// On each element of mass dm at r with the velocity v, both seen from the frame (V. I. Arnold, Mathematical Methods of
/// Classical Mechanics, 2nd ed., section 27):
///   dF = -dm (a + 2 W x v + W' x r + W x (W x r)),   a(t) = acceleration cos(frequency t),
///   W(t) = angular_velocity + angular_acceleration t,   in the axes of the frame.
struct FrameForce {
  Vector3 acceleration = Vector3::Zero();          ///< Of the frame's origin [m/s^2].
  Real frequency = 0;                              ///< [rad/s]
  Vector3 angular_velocity = Vector3::Zero();      ///< At t = 0 [rad/s].
  Vector3 angular_acceleration = Vector3::Zero();  ///< [rad/s^2]

  static constexpr const char* stage = "forces of the frame";
  static constexpr const char* one = "the motion of the frame";
  static constexpr Feature feature = Feature::frame_force;
  void add_features(Features& features) const { features.add(feature); }
  Vector3 turning(Time t) const { return angular_velocity + static_cast<Real>(t) * angular_acceleration; }
  bool turns() const { return !angular_velocity.isZero(0) || !angular_acceleration.isZero(0); }
  bool reads_velocities() const { return turns(); }
  bool reads_time() const { return frequency != 0 || !angular_acceleration.isZero(0); }
  bool holds_in_turning_frame() const { return false; }
  void mark_turned(std::vector<char>& turned) const {
    if (turns()) std::fill(turned.begin(), turned.end(), char{1});
  }
  void shift_anchors(int, const Vector3&) {}
  std::optional<Ends> ends() const { return std::nullopt; }
  std::optional<Acted> acts_on() const { return std::nullopt; }
  void renumber(const Numbering&) {}
};

}  // namespace cylon::engine
