#include "harness/scenario/vary.h"

#include "harness/core/event_find.h"
#include "harness/core/fields.h"
#include "harness/scenario/bind_motion.h"
#include "harness/scenario/budget.h"
#include "harness/scenario/certified_truth.h"
#include "reference/certified/truth.h"
#include "reference/exact/catalogue.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

namespace cylon::scenario {
namespace {

// Makes every number of one rank so much larger; whether any changed.
class Larger {
 public:
  Larger(int rank, double factor) : rank_(rank), factor_(factor) {}

  bool operator()(core::Scene& scene) {
    core::for_each_element(scene, [&](auto& element) { scale(element); });
    return changed_;
  }

 private:
  template <class T>
  void scale(T& element) {
    core::for_each_field(element, [&](const auto& field, auto& value) {
      using Value = std::remove_cvref_t<decltype(value)>;
      if constexpr (std::is_same_v<Value, core::BodyState>) {
        scale(value);
      } else if constexpr (std::is_same_v<Value, std::optional<core::Vector3>>) {
        if (field.about.start_rank != rank_ || !value) return;
        changed_ |= !value->isZero(0);
        *value *= factor_;
      } else if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, core::Vector3>) {
        if (field.about.start_rank != rank_) return;
        const Value was = value;
        value *= factor_;
        changed_ |= value != was;
      }
    });
  }

  const int rank_;
  const double factor_;
  bool changed_ = false;
};

core::Truth truth_of(const core::Claim& claim, const core::Scene& scene, double horizon) {
  if (claim.follows == certified_name) {
    certified::Solution solution = certified::solution(scene, horizon, budget::truth_work);
    if (solution.lost) throw core::OutOfDomain("the certified solution ends before the horizon");
    return std::move(solution.truth);
  }
  for (const exact::Solution& solution : exact::catalogue())
    if (solution.name == claim.follows) return exact::solve(solution, scene, horizon);
  throw core::OutOfDomain("recorded data is of one scene");
}

void follow(core::Claim& claim, const Scenario& scenario) {
  if (!claim.truth) return;
  const double horizon = std::min(claim.until, scenario.duration);
  core::Truth truth = truth_of(claim, scenario.scene, horizon);
  claim.truth = claim.observable.quantity == core::Quantity::event
                    ? core::with_events(claim.observable, scenario.scene, truth, horizon, scenario.step)
                    : std::move(truth);
  claim.truth_error =
      core::truth_error(claim.observable, scenario.scene, *claim.truth, horizon, scenario.step);
}

}  // namespace

std::optional<Scenario> varied(const Scenario& scenario, double amount) {
  require_prepared(scenario);
  for (int rank = 1; rank <= core::About::start_ranks; ++rank) {
    Scenario result = scenario;
    if (!Larger(rank, 1 + amount)(result.scene)) continue;
    try {
      for (core::Claim& claim : result.claims) follow(claim, result);
      bind_motion(result.claims, result.duration);
      return result;
    } catch (const core::OutOfDomain&) {
      continue;
    }
  }
  return std::nullopt;
}

}  // namespace cylon::scenario
