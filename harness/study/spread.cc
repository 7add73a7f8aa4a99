#include "harness/study/spread.h"

#include "harness/core/event_find.h"
#include "harness/core/last_step.h"
#include "harness/core/worst.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cylon::study {
namespace {

double event_spread(const core::Claim& claim, const core::Scene& scene, const core::Recording& one,
                    const core::Recording& other) {
  const core::Observable& q = claim.observable;
  const auto ours = core::find_events(q, scene, one), theirs = core::find_events(q, scene, other);
  if (q.event_quantity == core::EventQuantity::order) {
    double differing = 0;
    for (std::size_t i = 0; i < std::max(ours.size(), theirs.size()); ++i)
      differing += i < ours.size() && i < theirs.size() && ours[i].pair == theirs[i].pair ? 0 : 1;
    return differing;
  }
  if (q.event_quantity == core::EventQuantity::count) {
    const auto of_claim = [&](const core::Event& event) { return core::claimed(q, event); };
    return std::abs(
        static_cast<double>(std::ranges::count_if(ours, of_claim) - std::ranges::count_if(theirs, of_claim)));
  }
  double result = 0;
  for (const core::Event& event : ours) {
    if (event.kind != q.event || event.index != q.index) continue;
    const auto same = std::find_if(theirs.begin(), theirs.end(), [&](const core::Event& e) {
      return e.kind == event.kind && e.index == event.index && e.pair == event.pair;
    });
    const auto a = core::quantity(ours, event, q.event_quantity);
    const auto b = same == theirs.end() ? std::nullopt : core::quantity(theirs, *same, q.event_quantity);
    result = core::worst(a && b ? std::abs(*a - *b) : std::numeric_limits<double>::quiet_NaN(), result);
  }
  return result;
}

}  // namespace

core::Scene one_ulp_apart(const core::Scene& scene, int copy, int copies) {
  core::Scene nudged = scene;
  std::vector<double*> coordinates;
  for (core::Body& body : nudged.bodies) {
    if (body.locked) continue;
    for (core::Vector3* vector : {&body.initial.position, &body.initial.velocity})
      for (double& x : *vector)
        if (x != 0) coordinates.push_back(&x);
  }
  if (coordinates.empty()) {
    nudged.bodies.at(0).initial.position.x() = 0x1p-52;
    return nudged;
  }
  const auto count = static_cast<double>(coordinates.size());
  double& x = *coordinates[static_cast<std::size_t>(count * (2 * copy + 1) / (2 * copies))];
  x = std::nextafter(x, std::numeric_limits<double>::infinity());
  return nudged;
}

double spread(const core::Claim& claim, const core::Scene& scene, const core::Recording& one,
              const core::Recording& other) {
  if (claim.observable.quantity == core::Quantity::event) return event_spread(claim, scene, one, other);
  if (core::of_last_step(claim.observable.quantity))
    return core::spread_of_last_step(claim.observable, scene, one, other);
  std::size_t last = 0;
  for (std::size_t i = 0; i < std::min(one.states.size(), other.states.size()); ++i)
    if (one.time(i) <= claim.until * (1 + 1e-12)) last = i;
  core::Values ours, theirs;
  core::evaluate(claim.observable, scene, one.states.at(last), ours);
  core::evaluate(claim.observable, scene, other.states.at(last), theirs);
  return core::distance(claim.observable, ours, theirs);
}

}  // namespace cylon::study
