#include "harness/validation/kinematics.h"

#include "harness/tracking/statistics/bootstrap.h"
#include "reference/measured/coordinates.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace cylon::validation {
namespace {

using core::State, measured::Experiment;

// Sums of a slope.
struct Sums {
  double both = 0, square = 0;
  void add(const Eigen::VectorXd& step, const Eigen::VectorXd& rate) {
    both += step.dot(rate), square += rate.squaredNorm();
  }
  double slope() const { return both / square; }  // NaN where nothing moves
};

struct Pair {
  Sums velocity, spin;
};

core::Vector3 turn_between(const core::Quaternion& from, const core::Quaternion& to) {
  const Eigen::AngleAxisd turn(to * from.conjugate());
  return std::remainder(turn.angle(), 2 * std::numbers::pi) * turn.axis();
}

void add_free(const core::BodyState& a, const core::BodyState& b, double rate, Pair& sums) {
  sums.velocity.add(b.position - a.position, (a.velocity + b.velocity) / (2 * rate));
  sums.spin.add(turn_between(a.orientation, b.orientation),
                (a.angular_velocity + b.angular_velocity) / (2 * rate));
}

void add_chain(const Experiment& e, const State& a, const State& b, Pair& sums) {
  const auto angles = [&](const State& s) { return measured::chain_angles(e.model.scene, e.bodies, s); };
  const auto rates = [&](const State& s) { return measured::chain_rates(e.model.scene, e.bodies, s); };
  const Eigen::VectorXd step = (angles(b) - angles(a)).unaryExpr([](double turn) {
    return std::remainder(turn, 2 * std::numbers::pi);
  });
  sums.spin.add(step, (rates(a) + rates(b)) / (2 * e.rate));
}

Estimate over_runs(const std::vector<double>& slopes) {
  return {statistics::mean(slopes), statistics::bootstrap(slopes, statistics::mean, 0.025, 1), slopes.size()};
}

}  // namespace

Kinematics kinematics(const Experiment& e) {
  std::vector<double> velocities, spins;
  for (const measured::Run& run : e.runs) {
    Pair sums;
    for (std::size_t i = 1; i < run.states.size(); ++i) {
      const State &a = run.states[i - 1], &b = run.states[i];
      if (e.coordinates == measured::Coordinates::chain)
        add_chain(e, a, b, sums);
      else
        add_free(a[0], b[0], e.rate, sums);
    }
    if (std::isfinite(sums.velocity.slope())) velocities.push_back(sums.velocity.slope());
    if (std::isfinite(sums.spin.slope())) spins.push_back(sums.spin.slope());
  }
  return {over_runs(velocities), over_runs(spins)};
}

Answer goes_together(const Estimate& slope) {
  if (!std::isfinite(slope.value)) return Answer::undecided;
  // Of few runs there is no interval, and the value itself is held against the range.
  const bool known = std::isfinite(slope.interval.low);
  return answer(known ? slope.interval : statistics::Interval{slope.value, slope.value}, 0.9, 1.1);
}

}  // namespace cylon::validation
