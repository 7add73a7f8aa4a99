#include "reference/simulators/ode/ode_slip.h"

#include "harness/core/scene.h"

#include <ode/ode.h>

namespace cylon::simulators {
namespace {

using core::Vector3;

// Velocity of a body's point at a place of the world [m/s]; what has no body rests.
Vector3 velocity_at(dBodyID body, const dVector3& place) {
  if (!body) return Vector3::Zero();
  dVector3 v;
  dBodyGetPointVel(body, place[0], place[1], place[2], v);
  return {v[0], v[1], v[2]};
}

}  // namespace

void ode_turn_along_slip(dContact& contact, dBodyID first, dBodyID second) {
  constexpr double least_slip = 1e-9;  // [m/s]
  const Vector3 normal(contact.geom.normal[0], contact.geom.normal[1], contact.geom.normal[2]);
  const Vector3 v = velocity_at(first, contact.geom.pos) - velocity_at(second, contact.geom.pos);
  const Vector3 slip = v - v.dot(normal) * normal;
  contact.surface.mode &= ~dContactFDir1;
  if (!(slip.norm() > least_slip)) return;
  contact.surface.mode |= dContactFDir1;
  for (int k = 0; k < 3; ++k) contact.fdir1[k] = slip[k] / slip.norm();
}

}  // namespace cylon::simulators
