#include "engine/geometry/core.h"

namespace cylon::engine {

Couple::Couple(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose)
    : a(body),
      b(other),
      turn(pose.rotation.transpose() * other_pose.rotation),
      shift(pose.rotation.transpose() * (other_pose.position - pose.position)),
      size(a.size + b.size + shift.norm()) {}

}  // namespace cylon::engine
