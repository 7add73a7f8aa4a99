// The same scene in other words: moved, turned, mirrored, in other units, with other axes in its bodies.
// Physics does not depend on the words; what an engine makes of them may.
#pragma once

#include "harness/core/scene.h"

namespace cylon::study {

/// A change of description.  World vectors x become turn x (+ move for places), body vectors own a; units
/// change last.  `turn` and `own` are rotations or mirrors; a mirror of the world needs one of every body, so
/// that orientations stay rotations.
struct Restatement {
  core::Vector3 move = core::Vector3::Zero();      ///< [m]
  core::Matrix3 turn = core::Matrix3::Identity();  ///< World axes; orthogonal.
  core::Matrix3 own = core::Matrix3::Identity();   ///< Body axes; orthogonal, det own = det turn.
  double length = 1, mass = 1, time = 1;           ///< New units: x' = length x, m' = mass m, t' = time t.

  core::BodyState operator()(core::BodyState) const;
  core::State operator()(core::State) const;

  /// Every number of the scene, by its kind.  The caller sees to it that the scene has no part that the
  /// change cannot express: shapes with axes where `own` turns them, water, a turning frame that moves.
  core::Scene operator()(core::Scene) const;
};

}  // namespace cylon::study
