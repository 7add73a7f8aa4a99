// A scene in other words, and what its motion must then be.
#pragma once

#include "harness/study/restate.h"

namespace cylon::mutants {

/// A change of description, seen from a frame that moves on.
struct Restated {
  study::Restatement words = {};
  core::Vector3 boost = core::Vector3::Zero();  ///< [m/s]

  core::Scene operator()(const core::Scene&) const;
  core::State operator()(const core::State&, double time) const;
};

Restated turned(const core::Quaternion&);
Restated mirrored();
Restated boosted(const core::Vector3&);
Restated heavier(double factor);
Restated other_body_axes(const core::Quaternion&);

/// The scene with its bodies in the opposite order.
core::Scene in_reverse(core::Scene);

/// The scene with another start.
core::Scene started_from(core::Scene, const core::State&);

/// Position [m], velocity [m/s], angular velocity [rad/s] and orientation [rad], the largest difference over
/// the first bodies of both; NaN where anything is.
double apart(const core::State&, const core::State&);

}  // namespace cylon::mutants
