// Numbers of a scene as those of the engine, which may be of single precision.
#pragma once

#include "engine/rotation.h"
#include "harness/core/shapes.h"

namespace cylon::simulators {

inline engine::Real real(double x) { return static_cast<engine::Real>(x); }
inline engine::Vector3 real(const core::Vector3& v) { return v.cast<engine::Real>(); }
/// In float the rounded components are no unit quaternion any more.
inline engine::Quaternion real(const core::Quaternion& q) {
  return engine::renormalised(engine::Quaternion(q.cast<engine::Real>()));
}

}  // namespace cylon::simulators
