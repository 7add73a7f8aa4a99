#include "engine/ballistic/on_plane.h"

#include "engine/ballistic/encounter.h"

namespace cylon::engine::ballistic {

Supported on_plane(const Side& side, Real mass, const Vector3& n, const Vector3& gravity, Real mu,
                   bool slips) {
  constexpr Time forever = std::numeric_limits<Time>::infinity();
  const Real pressure = -n.dot(gravity);  // N/m
  const Vector3 level = gravity + pressure * n;
  const Vector3 g_t = size(level) <= rounding * size(gravity) ? Vector3(Vector3::Zero()) : level;
  const Real k = mass * side.tangential();
  Supported result;
  result.slip_ends = forever;
  result.acceleration = g_t;
  if (mu == 0) return result;

  const Vector3 raw = slip(side, {}, n), u = raw - n.dot(raw) * n;
  slips = slips && size(u) > rounding * (size(side.velocity) + size(side.rim()));
  Vector3 friction = -g_t / k;  // [m/s^2]
  if (slips || g_t.norm() > k * mu * pressure) {
    const Vector3 along = (slips ? u : g_t).normalized();
    result.straight = size(along.cross(g_t)) <= rounding * size(gravity);
    friction = -mu * pressure * along;
    const Real slowing = k * mu * pressure - along.dot(g_t);
    if (slips && slowing > rounding * size(gravity)) result.slip_ends = static_cast<Time>(u.norm() / slowing);
  }
  result.acceleration = g_t + friction;
  result.torque = -mass * side.radius * n.cross(friction);
  return result;
}

}  // namespace cylon::engine::ballistic
