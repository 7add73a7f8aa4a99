#include "harness/validation/score.h"

#include "harness/core/recording.h"
#include "harness/tracking/statistics/bootstrap.h"
#include "harness/tracking/statistics/holm.h"
#include "harness/tracking/statistics/proportion.h"
#include "harness/validation/length_scale.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

namespace cylon::validation {
namespace {

using core::BodyState, core::Quaternion, core::Scene, core::Vector3, measured::Experiment;

// Normal numbers that are the same on every machine: Box and Muller (1958), from 53 bits each.
class Normal {
 public:
  Normal(std::uint64_t seed, std::uint64_t run, std::uint64_t member) {
    std::seed_seq words{seed >> 32, seed & 0xffffffff, run, member};
    bits_.seed(words);
  }
  double operator()(double deviation) {
    const double radius = std::sqrt(-2 * std::log1p(-unit())), turn = 2 * std::numbers::pi * unit();
    return deviation * radius * std::cos(turn);
  }
  Vector3 vector(double deviation) {
    const double x = (*this)(deviation), y = (*this)(deviation), z = (*this)(deviation);
    return {x, y, z};
  }

 private:
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }  // [0, 1)
  std::mt19937_64 bits_;
};

Scene started(const Experiment& e, const BodyState& start) {
  Scene scene = e.model.scene;
  scene.bodies[e.body].initial = start;
  return scene;
}

Scene varied(const Experiment& e, const BodyState& start, Normal& normal) {
  Scene scene = started(e, start);
  BodyState& s = scene.bodies[e.body].initial;
  s.position += normal.vector(e.start.position);
  const Vector3 turn = normal.vector(e.start.orientation);
  if (const double angle = turn.norm(); angle > 0)
    s.orientation = (Eigen::AngleAxisd(angle, turn / angle) * s.orientation).normalized();
  s.velocity += normal.vector(e.start.velocity);
  s.angular_velocity += normal.vector(e.start.angular_velocity);
  for (core::Material& m : scene.materials) {
    m.friction = std::max(0.0, m.friction + normal(e.material.friction));
    m.restitution = std::clamp(m.restitution + normal(e.material.restitution), 0.0, 1.0);
  }
  return scene;
}

// The body's states at the frames of a run.
std::vector<BodyState> predicted(const Experiment& e, const Scene& scene, std::size_t frames,
                                 const study::Runner& runner) {
  const std::int64_t every = core::whole_steps(1 / e.rate, e.model.step);
  const auto last = static_cast<std::int64_t>(frames) - 1;
  const core::Recording r = runner(scene, e.model.step, last * every, every);
  std::vector<BodyState> states;
  for (std::size_t i = 0; i < r.states.size(); ++i)
    if (r.steps[i] % every == 0) states.push_back(r.states[i][e.body]);
  return states;
}

// Where the gap first comes below 5 mm, a straight line between frames: what gives in an impact, and what lengths are off,
// is less.
std::optional<double> first_touch(const Experiment& e, const std::vector<BodyState>& states) {
  constexpr double touching = 0.005;  // [m]
  double before = gap(e, states.front()) - touching;
  if (before <= 0) return std::nullopt;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const double now = gap(e, states[i]) - touching;
    if (now <= 0) return (static_cast<double>(i) - now / (now - before)) / e.rate;
    before = now;
  }
  return std::nullopt;
}

// The body axis of six that is nearest to up, as ±1, ±2, ±3.
int side(const BodyState& s) {
  const Vector3 up = s.orientation.conjugate() * Vector3::UnitY();
  Eigen::Index axis = 0;
  up.cwiseAbs().maxCoeff(&axis);
  return static_cast<int>(axis + 1) * (up[axis] > 0 ? 1 : -1);
}

double share_inside(const std::vector<std::vector<BodyState>>& members, const std::vector<BodyState>& states,
                    Normal& noise, double deviation) {
  std::size_t inside = 0, all = 0;
  for (std::size_t i = 1; i < states.size(); ++i) {
    Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const auto& member : members) {
      const Vector3 seen = member[i].position + noise.vector(deviation);
      low = low.cwiseMin(seen), high = high.cwiseMax(seen);
    }
    for (int k = 0; k < 3; ++k, ++all)
      inside += low[k] <= states[i].position[k] && states[i].position[k] <= high[k];
  }
  return static_cast<double>(inside) / static_cast<double>(all);
}

bool finite(const std::vector<BodyState>& states) {
  return std::ranges::all_of(states, [](const BodyState& s) {
    return s.position.allFinite() && s.orientation.coeffs().allFinite();
  });
}

}  // namespace

double level(int members) { return static_cast<double>(members - 1) / (members + 1); }

RunScore score(const Experiment& e, std::size_t run, const study::Runner& runner, const Band& band) {
  const std::vector<BodyState>& states = e.runs[run].states;
  RunScore found{.run = e.runs[run].name, .failure = {}};
  try {
    const auto path = predicted(e, started(e, states.front()), states.size(), runner);
    if (path.size() != states.size() || !finite(path)) {
      found.failure = "the prediction is not finite";
      return found;
    }
    found.distance = (path.back().position - states.back().position).norm();
    found.angle = path.back().orientation.angularDistance(states.back().orientation);
    found.same_side = side(path.back()) == side(states.back());
    const auto there = first_touch(e, path), here = first_touch(e, states);
    if (there && here) found.impact = *there - *here;
    std::vector<std::vector<BodyState>> members;
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
  std::vector<double> distance, angle, impact, covered;
  std::size_t same = 0;
  for (const RunScore& run : runs) {
    if (!run.failure.empty()) {
      if (all.failed++ == 0) all.first_failure = run.failure;
      continue;
    }
    distance.push_back(run.distance), angle.push_back(run.angle), same += run.same_side;
    if (std::isfinite(run.impact)) impact.push_back(std::abs(run.impact));
    if (std::isfinite(run.covered)) covered.push_back(run.covered);
  }
  const auto estimate = [](const std::vector<double>& values, auto of) {
    return Estimate{of(values), statistics::bootstrap(values, of, 0.025, 1), values.size()};
  };
  all.distance = estimate(distance, statistics::median), all.angle = estimate(angle, statistics::median);
  all.impact = estimate(impact, statistics::median);
  all.covered = {statistics::mean(covered), statistics::share_interval(covered, 0.025), covered.size()};
  if (!distance.empty())
    all.same_side = {static_cast<double>(same) / static_cast<double>(distance.size()),
                     statistics::proportion_interval(same, distance.size(), 0.025), distance.size()};
  all.band = answer(all.covered.interval, 0.90, 0.98);
  return all;
}

std::vector<Nearer> nearer(const std::vector<std::vector<RunScore>>& engines) {
  std::vector<Nearer> all;
  std::vector<double> p;
  for (std::size_t j = 1; j < engines.size(); ++j) {
    Nearer pair;
    for (std::size_t i = 0; i < engines[0].size(); ++i) {
      const RunScore &a = engines[0][i], &b = engines[j][i];
      if (!a.failure.empty() || !b.failure.empty()) continue;
      pair.one += a.distance < b.distance, pair.other += b.distance < a.distance;
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

}  // namespace cylon::validation
