#include "harness/validation/score.h"

#include "harness/tracking/statistics/bootstrap.h"
#include "harness/tracking/statistics/holm.h"
#include "harness/tracking/statistics/proportion.h"
#include "harness/validation/curves.h"
#include "harness/validation/length_scale.h"
#include "harness/validation/path.h"
#include "harness/validation/split.h"
#include "reference/measured/coordinates.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace cylon::validation {
namespace {

using core::BodyState, core::State, core::Vector3, measured::Experiment;

struct Touch {
  double time = 0;
  Vector3 centre;
};

// Where the gap first comes below 5 mm, a straight line between frames: what gives in an impact, and what lengths are off,
// is less.
std::optional<Touch> first_touch(const Experiment& e, const std::vector<State>& states) {
  constexpr double touching = 0.005;  // [m]
  double before = gap(e, states.front()[0]) - touching;
  if (before <= 0) return std::nullopt;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const double now = gap(e, states[i][0]) - touching;
    if (now <= 0) {
      const double later = now / (now - before);  // share of a frame
      return Touch{(static_cast<double>(i) - later) / e.rate,
                   states[i][0].position + later * (states[i - 1][0].position - states[i][0].position)};
    }
    before = now;
  }
  return std::nullopt;
}

// Distance along the scene's plane.
double along_plane(const Experiment& e, const Vector3& by) {
  const Vector3& normal = e.model.scene.planes[0].normal;
  return (by - normal.dot(by) * normal).norm();
}

// Kinetic energy, and potential energy above the height at which the centre lies on the plane [J].
double energy(const Experiment& e, const BodyState& s) {
  const core::Body& body = e.model.scene.bodies[e.bodies[0]];
  const core::Plane& plane = e.model.scene.planes[0];
  const double height = plane.normal.dot(s.position) - plane.offset,
               g = core::gravity_of(e.model.scene, body).norm();
  return body.mass * (s.velocity.squaredNorm() / 2 + g * height) +
         s.angular_velocity.dot(core::world_inertia(body, s.orientation) * s.angular_velocity) / 2;
}

// Share of the energy that is gone 0.1 s after the first touch.
std::optional<double> loss(const Experiment& e, const std::vector<State>& states) {
  const auto touch = first_touch(e, states);
  const auto frame = static_cast<std::size_t>(std::ceil(((touch ? touch->time : 0) + 0.1) * e.rate));
  if (!touch || frame >= states.size()) return std::nullopt;
  return 1 - energy(e, states[frame][0]) / energy(e, states[0][0]);
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
    const auto lost_there = loss(at, path), lost_here = loss(at, states);
    if (lost_there && lost_here) found.loss = *lost_there - *lost_here;
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
    shares.push_back(run.covered);
  }
  const auto estimate = [](const std::vector<double>& values, auto of) {
    return Estimate{of(values), statistics::bootstrap(values, of, 0.025, 1), values.size()};
  };
  all.distance = estimate(distance, statistics::median), all.angle = estimate(angle, statistics::median);
  all.impact = estimate(impact, statistics::median), all.loss = estimate(loss, statistics::median);
  all.place = estimate(place, statistics::median);
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
