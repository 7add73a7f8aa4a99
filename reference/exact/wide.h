// Vectors, quaternions and motions in 80-bit arithmetic: eleven bits spare for what a closed form cancels.
#pragma once

#include "harness/core/scene.h"

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace cylon::exact {

using Wide = long double;
using WideVector = Eigen::Matrix<Wide, 3, 1>;
using WideMatrix = Eigen::Matrix<Wide, 3, 3>;
using WideQuaternion = Eigen::Quaternion<Wide>;

/// A core::BodyState before it is rounded; the same units and axes.
struct WideState {
  WideVector position, velocity, angular_velocity;
  WideQuaternion orientation;
};

inline WideVector widen(const core::Vector3& v) { return v.cast<Wide>(); }
inline WideQuaternion widen(const core::Quaternion& q) { return q.cast<Wide>().normalized(); }

inline core::BodyState narrow(const WideState& s) {
  return {.position = s.position.cast<double>(),
          .orientation = s.orientation.normalized().cast<double>(),
          .velocity = s.velocity.cast<double>(),
          .angular_velocity = s.angular_velocity.cast<double>()};
}

/// Rotation by an angle [rad] about a unit axis.
inline WideQuaternion turn(const WideVector& axis, Wide angle) {
  const WideVector v = axis * std::sin(angle / 2);
  return {std::cos(angle / 2), v.x(), v.y(), v.z()};
}

/// Rotation by the vector w t; the identity for w = 0.
inline WideQuaternion turn_by(const WideVector& w, Wide t) {
  const Wide rate = w.norm();
  return rate == 0 ? WideQuaternion::Identity() : turn(w / rate, rate * t);
}

/// The shortest turn that takes one direction to another.  In wide.cc, as Eigen's templates for it take the
/// compiler three seconds in each source that uses them.
WideQuaternion turn_between(const WideVector& from, const WideVector& to);

/// The state of the whole scene from one motion per body; Motion::at(t) gives a WideState.
template <class Motion>
std::function<core::State(double)> together(std::vector<Motion> motions) {
  return [motions = std::move(motions)](double t) {
    core::State state;
    state.reserve(motions.size());
    for (const Motion& motion : motions) state.push_back(narrow(motion.at(t)));
    return state;
  };
}

}  // namespace cylon::exact
