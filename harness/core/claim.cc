#include "harness/core/claim.h"

#include "harness/core/event_rows.h"
#include "harness/core/joint_force.h"
#include "harness/core/observable_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace cylon::core {
namespace {

constexpr std::array<std::string_view, 7> reductions = {"max",  "end",      "mean_square", "order",
                                                        "rate", "increase", "decrease"};

}  // namespace

void require_truth(const Claim& claim) {
  if (!claim.follows.empty() && !claim.truth)
    throw std::logic_error(fmt::format("{}: the truth '{}' is not there", claim.label, claim.follows));
}

bool claimed(const Observable& q, const Event& event) {
  return event.kind == q.event && (of_all(q.event_quantity) || event.index == q.index) &&
         (!q.body || *q.body == event.pair.body || *q.body == event.pair.other) &&
         (!event_row(q.event).of_two_bodies || event.pair.other == q.to.value_or(world));
}

std::string_view name(Reduction reduction) { return reductions[static_cast<std::size_t>(reduction)]; }

std::string unit(const Claim& claim) {
  const std::string base(unit(claim.observable));
  switch (claim.reduction) {
    case Reduction::mean_square:
      return base.find(' ') == std::string::npos ? base + "^2" : "(" + base + ")^2";
    case Reduction::rate:
      return base + "/s";
    case Reduction::order:
      return "";
    case Reduction::max:
    case Reduction::end:
    case Reduction::increase:
    case Reduction::decrease:
      return base;
  }
  return base;
}

double truth_error(const Observable& q, const Scene& scene, const Truth& truth, double until, double step) {
  if (of_joint_forces(q.quantity)) return required_joint_forces(q, scene, truth, until, step).error;
  if (q.quantity == Quantity::event) return event_row(q.event_quantity).error(q, truth);
  const auto error_at = [&](double t) {
    return observable_row(q.quantity).error(q, scene, truth.state(t), truth.error);
  };
  double bound = 0;
  if (!truth.times.empty()) {
    for (const double t : truth.times) bound = std::max(bound, error_at(t));
    return bound;
  }
  constexpr int samples = 64;
  for (int i = 0; i <= samples; ++i)
    bound = std::max(bound, error_at(std::min(until, truth.horizon) * i / samples));
  return bound;
}

}  // namespace cylon::core
