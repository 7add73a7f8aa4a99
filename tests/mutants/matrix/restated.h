// A scene in other words, and what its motion must then be.
#pragma once

#include "harness/core/scene.h"

#include <functional>

namespace cylon::mutants {

/// A change of description: places and directions of the world, angular velocities, body axes, orientations,
/// inertias; units.
struct Restatement {
  using Map = std::function<core::Vector3(const core::Vector3&)>;
  Map place, direction, turning, own;  ///< Empty: the same.
  std::function<core::Quaternion(const core::Quaternion&)> orientation;
  std::function<core::Matrix3(const core::Matrix3&)> inertia;
  double mass = 1;
  core::Vector3 boost = core::Vector3::Zero();  ///< [m/s]

  core::Scene operator()(core::Scene) const;
  core::State operator()(core::State, double time) const;
};

Restatement turned(const core::Quaternion&);
Restatement mirrored();
Restatement boosted(const core::Vector3&);
Restatement heavier(double factor);
Restatement other_body_axes(const core::Quaternion&);

/// The scene with its bodies in the opposite order.
core::Scene in_reverse(core::Scene);

/// The scene with another start.
core::Scene started_from(core::Scene, const core::State&);

/// Position [m], velocity [m/s], angular velocity [rad/s] and orientation [rad], the largest difference over
/// the first bodies of both; NaN where anything is.
double apart(const core::State&, const core::State&);

}  // namespace cylon::mutants
