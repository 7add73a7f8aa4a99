#include "harness/validation/score.h"

#include "harness/tracking/statistics/bootstrap.h"
#include "harness/tracking/statistics/holm.h"
#include "harness/tracking/statistics/proportion.h"
#include "harness/validation/curves.h"
#include "harness/validation/length_scale.h"
#include "harness/validation/path.h"
#include "harness/validation/split.h"
#include "harness/validation/touches.h"
#include "reference/measured/coordinates.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace cylon::validation {
namespace {

using core::State, core::Vector3, measured::Experiment;

// Distance along the scene's plane.
double along_plane(const Experiment& e, const Vector3& by) {
  const Vector3& normal = e.model.scene.planes[0].normal;
  return (by - normal.dot(by) * normal).norm();
}

// Of each touch that both have a loss of; not known where either has none.
std::vector<double> differences(const std::vector<double>& one, const std::vector<double>& other) {
  std::vector<double> all;
  for (std::size_t k = 0; k < std::min(one.size(), other.size()); ++k) all.push_back(one[k] - other[k]);
  return all;
}

}  // namespace

RunScore score(const Experiment& e, std::size_t run, const study::Runner& runner, const Band& band,
               const Fitted& fitted) {
  const Experiment at = with_fit(with_run(e, run), fitted);
  const std::vector<State>& states = at.runs[0].states;
  RunScore found{.run = at.runs[0].name, .failure = {}};
  try {
    const auto path = predicted(at, measured::started(at, states.front()), states.size(), runner);
    if (path.size() != states.size() || !finite(path)) {
      found.failure = "the prediction is not finite";
      return found;
    }
    found.distance = (path.back()[0].position - states.back()[0].position).norm();
    found.angle = path.back()[0].orientation.angularDistance(states.back()[0].orientation);
    const Vector3 up = Vector3::UnitY();
    found.same_side = axis_towards(path.back()[0], up) == axis_towards(states.back()[0], up);
    const auto there = first_touch(at, path), here = first_touch(at, states);
    if (there && here) {
      found.impact = there->time - here->time;
      found.place = along_plane(at, there->centre - here->centre);
    }
    const auto lost_there = loss_after_first(at, path), lost_here = loss_after_first(at, states);
    if (lost_there && lost_here) found.loss = *lost_there - *lost_here;
    found.touch_losses = differences(losses_of_touches(at, path), losses_of_touches(at, states));
    if (band.members > 0)
      found.covered = share_inside(range(e, run, runner, band, fitted), curves(at, states, states.front()));
  } catch (const study::RunFailed& failed) {
    found.failure = failed.outcome.reason;
  }
  return found;
}

Answer answer(const statistics::Interval& interval, double low, double high) {
  if (low <= interval.low && interval.high <= high) return Answer::inside;
  if (interval.high < low || high < interval.low) return Answer::outside;
  return Answer::undecided;
}

const char* name(Answer answer) {
  return answer == Answer::inside ? "yes" : answer == Answer::outside ? "no" : "undecided";
}

Estimate covered(const std::vector<double>& shares) {
  std::vector<double> known;
  std::ranges::copy_if(shares, std::back_inserter(known), [](double share) { return std::isfinite(share); });
  return {statistics::mean(known), statistics::share_interval(known, 0.025), known.size()};
}

Answer band_answer(const Estimate& covered) { return answer(covered.interval, 0.90, 0.98); }

Summary summary(const std::vector<RunScore>& runs) {
  Summary all{.runs = runs.size(), .first_failure = {}};
  std::vector<double> distance, angle, impact, place, loss, shares;
  std::vector<std::vector<double>> touches;
  std::size_t same = 0;
  for (const RunScore& run : runs) {
    if (!run.failure.empty()) {
      if (all.failed++ == 0) all.first_failure = run.failure;
      continue;
    }
    distance.push_back(run.distance), angle.push_back(run.angle), same += run.same_side;
    if (std::isfinite(run.impact)) impact.push_back(std::abs(run.impact));
    if (std::isfinite(run.place)) place.push_back(run.place);
    if (std::isfinite(run.loss)) loss.push_back(run.loss);
    if (touches.size() < run.touch_losses.size()) touches.resize(run.touch_losses.size());
    for (std::size_t k = 0; k < run.touch_losses.size(); ++k)
      if (std::isfinite(run.touch_losses[k])) touches[k].push_back(run.touch_losses[k]);
    shares.push_back(run.covered);
  }
  const auto estimate = [](const std::vector<double>& values, auto of) {
    return Estimate{of(values), statistics::bootstrap(values, of, 0.025, 1), values.size()};
  };
  all.distance = estimate(distance, statistics::median), all.angle = estimate(angle, statistics::median);
  all.impact = estimate(impact, statistics::median), all.loss = estimate(loss, statistics::median);
  all.place = estimate(place, statistics::median);
  for (const std::vector<double>& of_touch : touches)
    all.touch_losses.push_back(estimate(of_touch, statistics::median));
  all.covered = covered(shares);
  if (!distance.empty())
    all.same_side = {static_cast<double>(same) / static_cast<double>(distance.size()),
                     statistics::proportion_interval(same, distance.size(), 0.025), distance.size()};
  all.band = band_answer(all.covered);
  return all;
}

std::vector<Better> better(const std::vector<std::vector<double>>& engines) {
  std::vector<Better> all;
  std::vector<double> p;
  for (std::size_t j = 1; j < engines.size(); ++j) {
    Better pair;
    for (std::size_t i = 0; i < std::min(engines[0].size(), engines[j].size()); ++i) {
      const double a = engines[0][i], b = engines[j][i];
      if (std::isfinite(a) && std::isfinite(b)) pair.one += a < b, pair.other += b < a;
    }
    p.push_back(statistics::sign_test(pair.one, pair.other));
    all.push_back(pair);
  }
  const std::vector<double> adjusted = statistics::holm(p);
  for (std::size_t j = 0; j < all.size(); ++j) {
    all[j].p = adjusted[j];
    if (adjusted[j] <= 0.05) all[j].answer = all[j].one > all[j].other ? Answer::inside : Answer::outside;
  }
  return all;
}

std::vector<Better> nearer(const std::vector<std::vector<RunScore>>& engines) {
  std::vector<std::vector<double>> distances;
  for (const std::vector<RunScore>& runs : engines) {
    std::vector<double>& of_runs = distances.emplace_back();
    for (const RunScore& run : runs) of_runs.push_back(run.failure.empty() ? run.distance : not_known);
  }
  return better(distances);
}

}  // namespace cylon::validation
