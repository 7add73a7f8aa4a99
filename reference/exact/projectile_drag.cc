// Bodies in uniform gravity with drag in proportion to their velocity, m p'' = m g - gamma p':
//
//     p = p0 + v0 S + g (t - S)/b,  S = (1 - exp(-b t))/b,  b = gamma/m
//
// in the form of linear_motion.h, which does not cancel where b t is small.  Bodies without drag fly as in
// vacuum.  Domain: gravity and drags, each body's spin steady (angular drag brakes it), no joint or contact.
#include "reference/exact/domain.h"
#include "reference/exact/linear_motion.h"
#include "reference/exact/solutions.h"

namespace cylon::exact {

core::Truth projectile_drag(const core::Scene& scene, double horizon) {
  constexpr auto name = "projectile_drag";
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity", "drag"});
  return linear_motions(name, scene, horizon, "Stokes' drag: m v' = m g - gamma v, linear and elementary");
}

}  // namespace cylon::exact
