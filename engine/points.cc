#include "engine/points.h"

namespace cylon::engine {

std::string not_points(const Model& model) {
  const Forces& forces = model.forces;
  if (!model.joints.empty()) return "the scene has joints";
  if (model.frame) return "the frame rotates";
  for (const Body& body : model.bodies) {
    if (body.mass_rate != 0) return "a body gains or loses mass";
  }
  if (!forces.drags.empty()) return "drag acts";
  if (!forces.thrusts.empty()) return "thrust acts";
  if (!forces.waters.empty()) return "water acts";
  for (const Spring& s : forces.springs) {
    const auto off_centre = [](int body, const Vector3& anchor) {
      return body != fixed_world && !anchor.isZero(0);
    };
    if (s.damping != 0) return "a spring is damped";
    if (off_centre(s.body, s.anchor) || off_centre(s.to, s.to_anchor)) return "a spring pulls off centre";
  }
  for (const Motion& motion : model.motions) {
    if (!motion.angular_momentum.isZero(0)) return "a body spins";
  }
  return "";
}

}  // namespace cylon::engine
