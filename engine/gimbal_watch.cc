#include "engine/gimbal_watch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cylon::engine {

namespace {

Vector3 turned(int body, const Vector3& v, const std::vector<Motion>& motions) {
  return body == fixed_world ? v : motions[static_cast<std::size_t>(body)].orientation * v;
}

// In [0, pi].
Real between_axes(const Coordinate& at, const std::vector<Motion>& motions) {
  const Vector3 axis = turned(at.on_body ? at.body : at.to, at.axis, motions),
                mark = turned(at.on_body ? at.to : at.body, at.mark, motions);
  return std::atan2(axis.cross(mark).norm(), axis.dot(mark));
}

Real from_parallel(Real angle) { return std::min(angle, std::numbers::pi_v<Real> - angle); }

}  // namespace

GimbalWatch::GimbalWatch(const Model& model) {
  for (const CoordinateLaw& law : model.forces.coordinate_laws) {
    const Coordinate& at = law.at;
    if (at.kind == Coordinate::Kind::azimuth || at.kind == Coordinate::Kind::inclination)
      gimbals_.push_back({at, between_axes(at, model.motions)});
  }
}

Real GimbalWatch::look(const std::vector<Motion>& motions) {
  Real most = 0;
  lost_.reset();
  for (Gimbal& gimbal : gimbals_) {
    const Real before = gimbal.angle;
    gimbal.angle = between_axes(gimbal.at, motions);
    const Real change = std::abs(gimbal.angle - before);
    // What moves on as before is there within a step, or little more as what acts grows.
    if (std::isnan(gimbal.angle) && from_parallel(before) <= 2 * gimbal.change) lost_ = from_parallel(before);
    gimbal.change = change;
    if (2 * change > std::min(from_parallel(before), from_parallel(gimbal.angle)))
      most = std::max(most, change);
  }
  return most;
}

}  // namespace cylon::engine
