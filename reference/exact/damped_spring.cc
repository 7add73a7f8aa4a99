// Bodies each on springs without rest length to pins in the world, with linear drag:
// m p'' = -k (p - c) - gamma p' + m g, under-damped, critical or over-damped by linear_motion.h.
// Domain: springs from the centre, undamped themselves, drags and gravity; spin steady; no joint or contact.
#include "reference/exact/domain.h"
#include "reference/exact/linear_motion.h"
#include "reference/exact/solutions.h"

namespace cylon::exact {

core::Truth damped_spring(const core::Scene& scene, double horizon) {
  constexpr auto name = "damped_spring";
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity", "drag", "spring"});
  check_springs(name, scene);
  check_no_rest_length(name, scene);
  return linear_motions(name, scene, horizon,
                        "Landau & Lifshitz, Mechanics, section 25: damped oscillations");
}

}  // namespace cylon::exact
