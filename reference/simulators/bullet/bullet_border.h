// Between Bullet's vectors and the harness's.  Included by the adapter's own sources only.
#pragma once

#include "harness/core/scene.h"

#include <LinearMath/btTransform.h>

namespace cylon::simulators {

inline btScalar to_bullet(double x) { return static_cast<btScalar>(x); }

inline btVector3 to_bullet(const core::Vector3& v) {
  return {to_bullet(v.x()), to_bullet(v.y()), to_bullet(v.z())};
}

inline btQuaternion to_bullet(const core::Quaternion& q) {
  return {to_bullet(q.x()), to_bullet(q.y()), to_bullet(q.z()), to_bullet(q.w())};
}

inline btTransform to_bullet(const core::Quaternion& q, const core::Vector3& origin) {
  return btTransform(to_bullet(q), to_bullet(origin));
}

inline core::Vector3 from_bullet(const btVector3& v) {
  return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}

inline core::Quaternion from_bullet(const btQuaternion& q) {
  return {static_cast<double>(q.w()), static_cast<double>(q.x()), static_cast<double>(q.y()),
          static_cast<double>(q.z())};
}

// Bullet's body frame is turned from ours by the principal axes A: R_bullet = R A.
inline btTransform pose_to_bullet(const core::Body& body, const core::PrincipalAxes& principal) {
  return to_bullet(body.initial.orientation * principal.rotation, body.initial.position);
}

inline core::Quaternion orientation_from_bullet(const btQuaternion& orientation,
                                                const core::Quaternion& principal) {
  return (from_bullet(orientation) * principal.conjugate()).normalized();
}

}  // namespace cylon::simulators
