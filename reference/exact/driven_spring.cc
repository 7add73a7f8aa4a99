// Bodies each on springs without rest length to pins in the world, with linear drag and forces F cos(Omega
// t): transient and steady state together by linear_motion.h, at resonance and without damping too. Domain:
// as damped_spring, and drives of any frequency.
#include "reference/exact/domain.h"
#include "reference/exact/linear_motion.h"
#include "reference/exact/solutions.h"

namespace cylon::exact {

core::Truth driven_spring(const core::Scene& scene, double horizon) {
  constexpr auto name = "driven_spring";
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity", "drag", "spring", "drive"});
  check_springs(name, scene);
  check_no_rest_length(name, scene);
  return linear_motions(name, scene, horizon,
                        "Landau & Lifshitz, Mechanics, section 26: forced oscillations under friction");
}

}  // namespace cylon::exact
