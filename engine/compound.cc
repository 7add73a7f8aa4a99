#include "engine/compound.h"

#include <cassert>

namespace cylon::engine {

CompoundPart merge(std::span<const CompoundPart> parts) {
  assert(!parts.empty());
  Real mass = 0;
  Vector3 moment = Vector3::Zero(), momentum = Vector3::Zero();
  bool locked = false;
  for (const CompoundPart& part : parts) {
    assert(!part.body.pinned);
    mass += part.body.mass;
    moment += part.body.mass * part.motion.position;
    momentum += part.motion.momentum;
    locked = locked || part.body.locked;
  }
  const Vector3 centre = moment / mass;

  Matrix3 inertia = Matrix3::Zero();  // world axes, about the centre
  Vector3 angular_momentum = Vector3::Zero();
  for (const CompoundPart& part : parts) {
    const Matrix3 r = part.motion.orientation.toRotationMatrix();
    const Vector3 d = part.motion.position - centre;
    inertia += r * part.body.inertia * r.transpose() +
               part.body.mass * (d.squaredNorm() * Matrix3::Identity() - d * d.transpose());
    angular_momentum += d.cross(part.motion.momentum) + part.motion.angular_momentum;
  }
  const Quaternion axes = parts.front().motion.orientation;
  const Matrix3 r = axes.toRotationMatrix();
  Matrix3 own = r.transpose() * inertia * r;
  own = (own + own.transpose().eval()) / 2;

  CompoundPart whole;
  whole.body = make_body(mass, own, locked);
  whole.motion = {centre, momentum, axes, angular_momentum};
  return whole;
}

}  // namespace cylon::engine
