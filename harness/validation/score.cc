#include "harness/validation/score.h"

#include "harness/tracking/statistics/bootstrap.h"
#include "harness/tracking/statistics/holm.h"
#include "harness/tracking/statistics/proportion.h"
#include "harness/validation/length_scale.h"
#include "harness/validation/normal.h"
#include "harness/validation/path.h"
#include "reference/measured/coordinates.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cylon::validation {
namespace {

using core::BodyState, core::Scene, core::State, core::Vector3, measured::Experiment;
using measured::measured_of, measured::moved, measured::started;

Scene varied(const Experiment& e, const State& start, Normal& normal) {
  Eigen::VectorXd drawn(e.start.cols());
  for (double& one : drawn) one = normal(1);
  Scene scene = started(e, moved(e, start, e.start * drawn));
  for (core::Material& m : scene.materials) {
    m.friction = std::max(0.0, m.friction + normal(e.material.friction));
    m.restitution = std::clamp(m.restitution + normal(e.material.restitution), 0.0, 1.0);
  }
  return scene;
}

// Where the gap first comes below 5 mm, a straight line between frames: what gives in an impact, and what lengths are off,
// is less.
std::optional<double> first_touch(const Experiment& e, const std::vector<State>& states) {
  constexpr double touching = 0.005;  // [m]
  double before = gap(e, states.front()[0]) - touching;
  if (before <= 0) return std::nullopt;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const double now = gap(e, states[i][0]) - touching;
    if (now <= 0) return (static_cast<double>(i) - now / (now - before)) / e.rate;
    before = now;
  }
  return std::nullopt;
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
  const auto frame = static_cast<std::size_t>(std::ceil((touch.value_or(0) + 0.1) * e.rate));
  if (!touch || frame >= states.size()) return std::nullopt;
  return 1 - energy(e, states[frame][0]) / energy(e, states[0][0]);
}

// The body axis of six that is nearest to up, as ±1, ±2, ±3.
int side(const BodyState& s) {
  const Vector3 up = s.orientation.conjugate() * Vector3::UnitY();
  Eigen::Index axis = 0;
  up.cwiseAbs().maxCoeff(&axis);
  return static_cast<int>(axis + 1) * (up[axis] > 0 ? 1 : -1);
}

double share_inside(const std::vector<std::vector<State>>& members, const std::vector<State>& states,
                    Normal& noise, double deviation) {
  std::size_t inside = 0, all = 0;
  for (std::size_t i = 1; i < states.size(); ++i) {
    Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const auto& member : members) {
      const Vector3 seen = member[i][0].position + noise.vector(deviation);
      low = low.cwiseMin(seen), high = high.cwiseMax(seen);
    }
    for (int k = 0; k < 3; ++k, ++all)
      inside += low[k] <= states[i][0].position[k] && states[i][0].position[k] <= high[k];
  }
  return static_cast<double>(inside) / static_cast<double>(all);
}

}  // namespace

double level(int members) { return static_cast<double>(members - 1) / (members + 1); }

RunScore score(const Experiment& e, std::size_t run, const study::Runner& runner, const Band& band) {
  const std::vector<State>& states = e.runs[run].states;
  RunScore found{.run = e.runs[run].name, .failure = {}};
  try {
    const auto path = predicted(e, started(e, states.front()), states.size(), runner);
    if (path.size() != states.size() || !finite(path)) {
      found.failure = "the prediction is not finite";
      return found;
    }
    found.distance = (path.back()[0].position - states.back()[0].position).norm();
    found.angle = path.back()[0].orientation.angularDistance(states.back()[0].orientation);
    found.same_side = side(path.back()[0]) == side(states.back()[0]);
    const auto there = first_touch(e, path), here = first_touch(e, states);
    if (there && here) found.impact = *there - *here;
    const auto lost_there = loss(e, path), lost_here = loss(e, states);
    if (lost_there && lost_here) found.loss = *lost_there - *lost_here;
    std::vector<std::vector<State>> members;
    for (int m = 0; m < band.members; ++m) {
      Normal normal(band.seed, run, static_cast<std::uint64_t>(m));
      members.push_back(predicted(e, varied(e, states.front(), normal), states.size(), runner));
      if (members.back().size() != states.size() || !finite(members.back())) {
        found.failure = "a prediction of the band is not finite";
        return found;
      }
    }
    if (band.members > 0) {
      Normal noise(band.seed, run, static_cast<std::uint64_t>(band.members));
      found.covered = share_inside(members, states, noise, e.noise);
    }
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

Summary summary(const std::vector<RunScore>& runs) {
  Summary all{.runs = runs.size(), .first_failure = {}};
  std::vector<double> distance, angle, impact, loss, covered;
  std::size_t same = 0;
  for (const RunScore& run : runs) {
    if (!run.failure.empty()) {
      if (all.failed++ == 0) all.first_failure = run.failure;
      continue;
    }
    distance.push_back(run.distance), angle.push_back(run.angle), same += run.same_side;
    if (std::isfinite(run.impact)) impact.push_back(std::abs(run.impact));
    if (std::isfinite(run.loss)) loss.push_back(run.loss);
    if (std::isfinite(run.covered)) covered.push_back(run.covered);
  }
  const auto estimate = [](const std::vector<double>& values, auto of) {
    return Estimate{of(values), statistics::bootstrap(values, of, 0.025, 1), values.size()};
  };
  all.distance = estimate(distance, statistics::median), all.angle = estimate(angle, statistics::median);
  all.impact = estimate(impact, statistics::median), all.loss = estimate(loss, statistics::median);
  all.covered = {statistics::mean(covered), statistics::share_interval(covered, 0.025), covered.size()};
  if (!distance.empty())
    all.same_side = {static_cast<double>(same) / static_cast<double>(distance.size()),
                     statistics::proportion_interval(same, distance.size(), 0.025), distance.size()};
  all.band = answer(all.covered.interval, 0.90, 0.98);
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
