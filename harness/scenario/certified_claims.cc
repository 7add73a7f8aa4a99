#include "harness/scenario/certified_claims.h"

#include "harness/core/event_find.h"
#include "harness/scenario/bind_motion.h"
#include "harness/scenario/certified_truth.h"
#include "harness/scenario/claim_observable.h"
#include "harness/scenario/claim_tolerance.h"
#include "harness/scenario/claim_truths.h"
#include "harness/scenario/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cylon::scenario {
namespace {

void solve(core::Claim& claim, const Table& t, const Scenario& scenario, CertifiedTruths& truths) {
  const core::Scene& scene = scenario.scene;
  const bool while_predictable = t.is_text("until");
  const double horizon = std::min(claim.until, scenario.duration);
  const certified::Solution& solution = truths.at(t, scene, horizon);
  if (!while_predictable) require_whole(t, solution, horizon);
  try {
    claim.truth = claim.observable.quantity == core::Quantity::event
                      ? core::with_events(claim.observable, scene, solution.truth, horizon, scenario.step)
                      : solution.truth;
  } catch (const core::OutOfDomain& error) {
    t.fail("follows", fmt::format("follows = '{}': {}", claim.follows, error.what()));
  }
  if (while_predictable) {
    claim.until = predictable(t, claim, scene, solution, scenario.duration);
    claim.label = label_of(t, claim);
  }
  require_event(t, claim, horizon);
  check_tolerance(t, claim, scene, scenario.duration, scenario.step);
}

}  // namespace

CertifiedClaims::CertifiedClaims(std::shared_ptr<const Document> document, std::vector<CertifiedClaim> claims)
    : document_(std::move(document)), claims_(std::move(claims)) {}

std::vector<core::Claim> CertifiedClaims::solved(const Scenario& scenario, double most_work) const {
  std::vector<core::Claim> claims = scenario.claims;
  CertifiedTruths truths(most_work);
  for (const auto& [index, table] : claims_) {
    solve(claims[index], table, scenario, truths);
    if (std::ranges::count(claims, claims[index].label, &core::Claim::label) > 1)
      table.fail(fmt::format("the claim '{}' is made twice", claims[index].label));
  }
  bind_motion(claims, scenario.duration);
  return claims;
}

}  // namespace cylon::scenario
