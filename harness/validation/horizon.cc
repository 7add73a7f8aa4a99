#include "harness/validation/horizon.h"

#include "harness/study/parallel.h"
#include "harness/tracking/statistics/bootstrap.h"
#include "harness/validation/curves.h"
#include "harness/validation/path.h"
#include "harness/validation/split.h"
#include "reference/measured/coordinates.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cylon::validation {
namespace {

using measured::Experiment;

constexpr double infinite = std::numeric_limits<double>::infinity();

// Differences of angles at each frame, of two paths from starts that differ.
std::vector<Eigen::VectorXd> apart(const Experiment& e, const std::vector<core::State>& one,
                                   const std::vector<core::State>& other) {
  std::vector<Eigen::VectorXd> all;
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i)
    all.push_back(measured::difference(e, one[i], other[i]));
  return all;
}

// By a column of changes of the start: half the difference of the paths to either side, over the share of it.
std::vector<Eigen::VectorXd> change(const Experiment& e, const core::State& start, std::size_t frames,
                                    const Eigen::VectorXd& by, const study::Runner& runner) {
  constexpr double share = 0.01;
  const auto path = [&](double sign) {
    return predicted(e, measured::started(e, measured::moved(e, start, sign * share * by)), frames, runner);
  };
  std::vector<Eigen::VectorXd> all = apart(e, path(1), path(-1));
  for (Eigen::VectorXd& one : all) one /= 2 * share;
  return all;
}

// The median; of an even number of runs, half of which hold to the end, the longest of the others, as the mean of both is no time.
double median_time(std::span<const double> times) {
  const double middle = statistics::median(times);
  if (!std::isinf(middle)) return middle;
  std::vector<double> sorted(times.begin(), times.end());
  std::ranges::sort(sorted);
  return sorted[(sorted.size() - 1) / 2];
}

}  // namespace

Horizon horizon(const Experiment& e, std::size_t run, const study::Runner& runner, double bound) {
  const std::vector<core::State>& states = e.runs[run].states;
  Horizon found{.run = e.runs[run].name, .failure = {}};
  try {
    const auto path = predicted(e, measured::started(e, states[0]), states.size(), runner);
    if (path.size() != states.size() || !finite(path)) {
      found.failure = "the prediction is not finite";
      return found;
    }
    const auto time = [&](std::size_t frame) { return static_cast<double>(frame) / e.rate; };
    found.held = infinite;
    for (std::size_t i = 0; i < states.size(); ++i)
      if (measured::difference(e, states[i], path[i]).cwiseAbs().maxCoeff() > bound) {
        found.held = time(i);
        break;
      }
    const auto n = static_cast<Eigen::Index>(e.bodies.size());
    std::vector<Eigen::VectorXd> variance(states.size(), Eigen::VectorXd::Zero(n));
    std::vector<Eigen::MatrixXd> growth(states.size(), Eigen::MatrixXd::Zero(n, n));
    for (Eigen::Index i = 0; i < e.start.cols(); ++i) {
      const auto by_column = change(e, states[0], states.size(), e.start.col(i), runner);
      for (std::size_t k = 0; k < by_column.size(); ++k) variance[k] += by_column[k].cwiseAbs2();
    }
    constexpr double turn = 1e-3;  // of which `change` takes a hundredth [rad]
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto by_angle =
          change(e, states[0], states.size(), turn * Eigen::VectorXd::Unit(2 * n, i), runner);
      for (std::size_t k = 0; k < by_angle.size(); ++k) growth[k].col(i) = by_angle[k] / turn;
    }
    constexpr double half_of_cases = 0.6745;  // P(|z| < 0.6745) = 1/2, z standard normal
    std::size_t until = states.size() - 1;
    found.expected = infinite;
    for (std::size_t k = 0; k < states.size(); ++k)
      if (half_of_cases * std::sqrt(variance[k].maxCoeff()) > bound) {
        found.expected = time(k), until = std::max<std::size_t>(k, 1);
        break;
      }
    const double size = Eigen::JacobiSVD<Eigen::MatrixXd>(growth[until]).singularValues()[0];
    found.exponent = std::log(size) / time(until);
  } catch (const study::RunFailed& failed) {
    found.failure = failed.outcome.reason;
  }
  return found;
}

Horizon horizon(const Experiment& e, std::size_t run, const study::Runner& runner, const Band& band,
                const Fitted& fitted) {
  const Experiment at = with_fit(with_run(e, run), fitted);
  Horizon found = horizon(at, 0, runner);
  if (band.members == 0 || !found.failure.empty()) return found;
  try {
    const std::vector<core::State>& states = at.runs[0].states;
    found.covered = share_inside(range(e, run, runner, band, fitted), curves(at, states, states.front()));
  } catch (const study::RunFailed& failed) {
    found.failure = failed.outcome.reason;
  }
  return found;
}

std::vector<Horizon> horizons(const Experiment& e, std::span<const std::size_t> runs,
                              const study::Runner& runner, int jobs) {
  std::vector<Horizon> all(runs.size());
  study::in_parallel(runs.size(), jobs, [&](std::size_t i) { all[i] = horizon(e, runs[i], runner); });
  return all;
}

HorizonSummary summary(const std::vector<Horizon>& runs) {
  HorizonSummary all{.runs = runs.size(), .first_failure = {}};
  std::vector<double> held, expected, exponent, shares;
  for (const Horizon& run : runs) {
    if (!run.failure.empty()) {
      if (all.failed++ == 0) all.first_failure = run.failure;
      continue;
    }
    all.to_the_end += std::isinf(run.held);
    held.push_back(run.held), expected.push_back(run.expected), exponent.push_back(run.exponent);
    shares.push_back(run.covered);
  }
  const auto estimate = [](const std::vector<double>& values) {
    return Estimate{median_time(values), statistics::bootstrap(values, median_time, 0.025, 1), values.size()};
  };
  all.held = estimate(held), all.expected = estimate(expected), all.exponent = estimate(exponent);
  all.covered = covered(shares), all.band = band_answer(all.covered);
  return all;
}

}  // namespace cylon::validation
