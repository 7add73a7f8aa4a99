// A scene with z up, as other formats have it: (x, y, z) -> (x, -z, y), in world and body axes alike.  The inverse of
// harness/imports/turn.cc; permutes numbers and rounds none.
#pragma once

#include "harness/core/scene.h"

namespace cylon::exports {

/// P, the turn of 90 degrees about x.
inline core::Vector3 z_up(const core::Vector3& v) { return {v.x(), 0.0 - v.z(), v.y()}; }  // no -0

/// P q P^-1: the axis of q turns, its angle stays.
inline core::Quaternion z_up(const core::Quaternion& q) {
  const core::Vector3 axis = z_up(core::Vector3(q.vec()));
  return {q.w(), axis.x(), axis.y(), axis.z()};
}

/// P I P^T.
inline core::Matrix3 z_up(const core::Matrix3& i) {
  core::Matrix3 m;
  m << i(0, 0), 0.0 - i(0, 2), i(0, 1),       //
      0.0 - i(2, 0), i(2, 2), 0.0 - i(2, 1),  //
      i(1, 0), 0.0 - i(1, 2), i(1, 1);
  return m;
}

/// Half extents, which have no sign.
inline core::Vector3 z_up_extents(const core::Vector3& half) { return {half.x(), half.z(), half.y()}; }

}  // namespace cylon::exports
