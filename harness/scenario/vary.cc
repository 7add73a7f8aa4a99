#include "harness/scenario/vary.h"

#include "harness/core/event_find.h"
#include "harness/scenario/certified_truth.h"
#include "reference/certified/truth.h"
#include "reference/exact/catalogue.h"

#include <algorithm>
#include <stdexcept>

namespace cylon::scenario {
namespace {

bool scale_velocities(core::Scene& scene, double factor) {
  bool moves = false;
  for (core::Body& body : scene.bodies) {
    moves |= !body.initial.velocity.isZero(0) || !body.initial.angular_velocity.isZero(0);
    body.initial.velocity *= factor, body.initial.angular_velocity *= factor;
  }
  return moves;
}

template <class Kind, class Change>
bool change_forces(core::Scene& scene, const Change& change) {
  bool any = false;
  for (core::Force& force : scene.forces)
    if (auto* found = std::get_if<Kind>(&force)) change(*found), any = true;
  return any;
}

bool scale_gravity(core::Scene& scene, double factor) {
  return change_forces<core::UniformGravity>(scene,
                                             [&](core::UniformGravity& g) { g.acceleration *= factor; });
}

bool stiffen(core::Scene& scene, double factor) {
  return change_forces<core::Spring>(scene, [&](core::Spring& s) { s.stiffness *= factor; });
}

constexpr bool (*changes[])(core::Scene&, double) = {scale_velocities, scale_gravity, stiffen};

core::Truth truth_of(const core::Claim& claim, const core::Scene& scene, double horizon) {
  if (claim.follows == certified_name) {
    certified::Solution solution = certified::solution(scene, horizon);
    if (solution.lost) throw core::OutOfDomain("the certified solution ends before the horizon");
    return std::move(solution.truth);
  }
  for (const exact::Solution& solution : exact::catalogue())
    if (solution.name == claim.follows) return solution.make(scene, horizon);
  throw core::OutOfDomain("recorded data is of one scene");
}

void follow(core::Claim& claim, const Scenario& scenario) {
  if (!claim.truth) return;
  const double horizon = std::min(claim.until, scenario.duration);
  core::Truth truth = truth_of(claim, scenario.scene, horizon);
  claim.truth = claim.observable.quantity == core::Quantity::event
                    ? core::with_events(claim.observable, scenario.scene, truth, horizon, scenario.step)
                    : std::move(truth);
  claim.truth_error = core::truth_error(claim.observable, scenario.scene, *claim.truth, horizon);
}

}  // namespace

std::optional<Scenario> varied(const Scenario& scenario, double amount) {
  require_prepared(scenario);
  for (const auto change : changes) {
    Scenario result = scenario;
    if (!change(result.scene, 1 + amount)) continue;
    try {
      for (core::Claim& claim : result.claims) follow(claim, result);
      return result;
    } catch (const core::OutOfDomain&) {
      continue;
    }
  }
  return std::nullopt;
}

}  // namespace cylon::scenario
