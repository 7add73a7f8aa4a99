#include "harness/core/last_step.h"

#include "harness/core/force_balance.h"
#include "harness/core/joint_force.h"

#include <fmt/format.h>

#include <cmath>

namespace cylon::core {
namespace {

RequiredForces required(const Claim& claim, const Scene& scene, const Recording& recording) {
  return required_joint_forces(claim.observable, scene, *claim.truth,
                               recording.time(recording.steps.size() - 1), recording.dt);
}

}  // namespace

std::optional<std::string> untold_of_last_step(const Observable& q, const Scene& scene,
                                               const Recording& recording) {
  return of_joint_forces(q.quantity) ? joint_force_untold(q, scene, recording) : untold(q, scene, recording);
}

double deviation_of_last_step(const Claim& claim, const Scene& scene, const Recording& recording) {
  const Observable& q = claim.observable;
  if (!of_joint_forces(q.quantity)) return force_imbalance(q, scene, recording);
  if (joint_force_untold(q, scene, recording)) return 0;
  return distance(q, told_joint_forces(q, scene, recording), required(claim, scene, recording).values);
}

std::optional<std::string> too_short_a_step(const Claim& claim, const Scene& scene,
                                            const Recording& recording, double allowed) {
  if (!of_joint_forces(claim.observable.quantity)) return std::nullopt;
  const double error = required(claim, scene, recording).error;
  if (error <= allowed / 10) return std::nullopt;
  return fmt::format(
      "over a step of {:.3g} s '{}' is only good to {:.3g} {}, but a tenth of the {:.3g} allowed is needed",
      recording.dt, claim.follows, error, unit(claim.observable), allowed);
}

double spread_of_last_step(const Observable& q, const Scene& scene, const Recording& one,
                           const Recording& other) {
  if (!of_joint_forces(q.quantity))
    return std::abs(force_imbalance(q, scene, one) - force_imbalance(q, scene, other));
  if (joint_force_untold(q, scene, one) || joint_force_untold(q, scene, other)) return 0;
  return distance(q, told_joint_forces(q, scene, one), told_joint_forces(q, scene, other));
}

}  // namespace cylon::core
