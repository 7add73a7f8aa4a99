#include "harness/scenario/certified_truth.h"

#include "harness/core/measure.h"
#include "harness/core/scale.h"
#include "harness/scenario/budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cylon::scenario {

const certified::Solution& CertifiedTruths::at(const Table& claim, const core::Scene& scene, double horizon) {
  const auto place = known_.find(horizon);
  if (place != known_.end()) return place->second;
  try {
    certified::Solution solution = certified::solution(scene, horizon, most_work_ - work_);
    work_ += solution.work;
    return known_.emplace(horizon, std::move(solution)).first->second;
  } catch (const certified::TooMuchWork& error) {
    if (most_work_ < budget::truth_work) throw;
    claim.fail("follows", fmt::format("follows = '{}': {}", certified_name, error.what()));
  } catch (const core::OutOfDomain& error) {
    claim.fail("follows",
               fmt::format("follows = '{}' does not serve this scene: {} (it serves: smooth scenes)",
                           certified_name, error.what()));
  }
}

void require_whole(const Table& claim, const certified::Solution& solution, double horizon) {
  if (!solution.lost || solution.truth.horizon >= horizon) return;
  claim.fail("follows",
             fmt::format("follows = '{}': after {:.4g} s an error in the last place of the initial "
                         "state has grown beyond 1 (m, m/s, rad or rad/s), and no engine can follow; "
                         "say until = \"horizon\", or a time before that",
                         certified_name, solution.truth.horizon));
}

double predictable(const Table& t, const core::Claim& claim, const core::Scene& scene,
                   const certified::Solution& solution, double duration) {
  const auto holds = [&](double time) {
    const auto later = [time](const certified::Amplified& a) { return a.time < time; };
    const auto ulp = std::ranges::find_if_not(solution.ulp, later);
    if (ulp == solution.ulp.end() || time > solution.truth.horizon) return false;
    core::Claim cut = claim;
    cut.until = time;
    core::Truth off = solution.truth;
    off.error = ulp->error;
    const double allowed = core::allowed(cut, scene, duration, core::epsilon_of_double);
    return core::truth_error(cut.observable, scene, off, time, time) <= allowed / 10;  // never of a last step
  };
  constexpr int times = 200;
  int good = 0, bad = times + 1;  // both sides of the last time that holds
  while (bad - good > 1) {
    const int middle = good + (bad - good) / 2;
    (holds(duration * middle / times) ? good : bad) = middle;
  }
  if (good == 0)
    t.fail("until",
           fmt::format("until = \"horizon\": even after {:.3g} s an error in the last place of the initial "
                       "state exceeds a tenth of the tolerance",
                       duration / times));
  return duration * good / times;
}

}  // namespace cylon::scenario
