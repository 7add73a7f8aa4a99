#include "harness/validation/likelihood.h"

#include "harness/core/input_error.h"
#include "harness/core/joint_coordinates.h"
#include "harness/study/parallel.h"
#include "harness/validation/path.h"
#include "reference/measured/coordinates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cylon::validation {
namespace {

using measured::Experiment, measured::Parameter;

// A window begins at t = 0 of its own.
void require_laws_of_no_time(const Experiment& e) {
  for (const core::Force& force : e.model.scene.forces)
    if (std::holds_alternative<core::Drive>(force) || std::holds_alternative<core::Water>(force) ||
        std::holds_alternative<core::Thrust>(force) || std::holds_alternative<core::PluginForce>(force))
      throw core::InputError(
          fmt::format("{}: a drive, a thrust, water or a plug-in changes with time, and windows of a run "
                      "begin at different "
                      "times",
                      e.model.file));
  for (const core::Joint& joint : e.model.scene.joints)
    core::for_each_coordinate(joint, [&](const core::JointCoordinate& c) {
      if (core::target_moves(c))
        throw core::InputError(fmt::format(
            "{}: the target of a joint moves, and windows of a run begin at different times", e.model.file));
    });
}

study::RunFailed not_finite() {
  process::RunOutcome outcome;
  outcome.status = results::Status::fail;
  outcome.reason = "the prediction is not finite";
  return {outcome};
}

}  // namespace

Likelihood::Likelihood(const Experiment& e, std::vector<Parameter> parameters, std::vector<std::size_t> runs,
                       study::Runner runner, int jobs)
    : experiment_(e),
      parameters_(std::move(parameters)),
      runs_(std::move(runs)),
      runner_(std::move(runner)),
      jobs_(jobs) {
  if (!(e.fit.horizon > 0))
    throw core::InputError(fmt::format("{}: [fit] states no horizon, the length of the windows", e.file));
  if (!(measured::noise(e).array() > 0).all())
    throw core::InputError(
        fmt::format("{}: [uncertainty] states no {}: nothing is likely without noise", e.file,
                    e.coordinates == measured::Coordinates::free ? "noise" : "angle_noise"));
  require_laws_of_no_time(e);
  frames_ = static_cast<std::size_t>(std::floor(e.fit.horizon * e.rate * (1 + 1e-12))) + 1;
  for (const std::size_t run : runs_) {
    const std::size_t all = e.runs[run].states.size();
    for (std::size_t first = 0; first + frames_ <= all; first += frames_) windows_.push_back({run, first});
    left_over_ += all % frames_;
  }
  if (windows_.empty())
    throw core::InputError(fmt::format("{}: no run has the {} frames of a window", e.file, frames_));
}

std::size_t Likelihood::numbers() const {
  return windows_.size() * (frames_ - 1) * static_cast<std::size_t>(measured::noise(experiment_).size());
}

Eigen::VectorXd Likelihood::residual(const Experiment& e, const Window& window,
                                     const core::State& start) const {
  const std::vector<core::State>& states = e.runs[window.run].states;
  const auto path = predicted(e, measured::started(e, start), frames_, runner_);
  if (path.size() != frames_ || !finite(path)) throw not_finite();
  const Eigen::Index width = measured::noise(e).size();
  Eigen::VectorXd all(static_cast<Eigen::Index>(frames_ - 1) * width);
  for (std::size_t i = 1; i < frames_; ++i)
    all.segment(static_cast<Eigen::Index>(i - 1) * width, width) =
        measured::difference(e, states[window.first + i], path[i]);
  return all;
}

void Likelihood::renew(std::span<const double> values) {
  const Experiment e = measured::with_values(experiment_, parameters_, values);
  gauss_.assign(windows_.size(), {});
  const Eigen::VectorXd variance =
      measured::noise(e).array().square().matrix().replicate(static_cast<Eigen::Index>(frames_ - 1), 1);
  std::vector<Eigen::Index> ways;
  for (Eigen::Index i = 0; i < e.start.cols(); ++i)
    if (!e.start.col(i).isZero(0)) ways.push_back(i);
  study::in_parallel(windows_.size(), jobs_, [&](std::size_t w) {
    const core::State& start = e.runs[windows_[w].run].states[windows_[w].first];
    const Eigen::VectorXd here = residual(e, windows_[w], start);
    Eigen::MatrixXd covariance = variance.asDiagonal();
    gauss_[w].shift = Eigen::VectorXd::Zero(here.size());
    for (const Eigen::Index i : ways) {
      const Eigen::VectorXd there = residual(e, windows_[w], measured::moved(e, start, e.start.col(i))),
                            back = residual(e, windows_[w], measured::moved(e, start, -e.start.col(i))),
                            slope = (there - back) / 2, bend = there + back - 2 * here;
      covariance += slope * slope.transpose() + 0.5 * bend * bend.transpose();
      gauss_[w].shift += bend / 2;
    }
    gauss_[w].covariance.compute(covariance);
    gauss_[w].log_determinant = 2 * gauss_[w].covariance.matrixLLT().diagonal().array().log().sum();
  });
  predictions_ += windows_.size() * (1 + 2 * ways.size());
}

std::vector<Eigen::VectorXd> Likelihood::residuals(std::span<const double> values) {
  const Experiment e = measured::with_values(experiment_, parameters_, values);
  std::vector<Eigen::VectorXd> all(windows_.size());
  study::in_parallel(windows_.size(), jobs_, [&](std::size_t w) {
    all[w] = residual(e, windows_[w], e.runs[windows_[w].run].states[windows_[w].first]) + gauss_[w].shift;
  });
  predictions_ += windows_.size();
  return all;
}

// Gauss: log det C + q.  With nu degrees of freedom and n numbers: log det C + (nu + n) log(1 + q/nu), of the multivariate t
// density, less its constants (Kotz and Nadarajah 2004, eq. 1.1).
double Likelihood::deviance(std::size_t window, double misfit) const {
  const double nu = experiment_.fit.degrees, n = static_cast<double>(gauss_[window].shift.size());
  return gauss_[window].log_determinant + (std::isfinite(nu) ? (nu + n) * std::log1p(misfit / nu) : misfit);
}

std::vector<double> Likelihood::deviances(std::span<const double> values) {
  const std::vector<Eigen::VectorXd> all = residuals(values);
  std::vector<double> of_run(runs_.size(), 0);
  for (std::size_t w = 0, r = 0; w < windows_.size(); ++w) {
    while (runs_[r] != windows_[w].run) ++r;
    of_run[r] += deviance(w, gauss_[w].covariance.matrixL().solve(all[w]).squaredNorm());
  }
  return of_run;
}

double Likelihood::deviance(std::span<const double> values) {
  double sum = 0;
  for (const double one : deviances(values)) sum += one;
  return sum;
}

double Likelihood::misfit(std::span<const double> values) {
  const std::vector<Eigen::VectorXd> all = residuals(values);
  double sum = 0;
  for (std::size_t w = 0; w < windows_.size(); ++w)
    sum += gauss_[w].covariance.matrixL().solve(all[w]).squaredNorm();
  return sum;
}

Score Likelihood::score(std::span<const double> values, std::span<const double> lengths) {
  const auto k = static_cast<Eigen::Index>(parameters_.size());
  const std::vector<Eigen::VectorXd> here = residuals(values);
  std::vector<Eigen::MatrixXd> slopes;
  for (const Eigen::VectorXd& r : here) slopes.emplace_back(r.size(), k);
  for (Eigen::Index j = 0; j < k; ++j) {
    const auto at = static_cast<std::size_t>(j);
    std::vector<double> up(values.begin(), values.end()), down = up;
    up[at] = std::min(parameters_[at].high, values[at] + lengths[at]);
    down[at] = std::max(parameters_[at].low, values[at] - lengths[at]);
    const std::vector<Eigen::VectorXd> there = residuals(up), back = residuals(down);
    for (std::size_t w = 0; w < here.size(); ++w)  // a residual falls as a prediction rises
      slopes[w].col(j) = (back[w] - there[w]) / (up[at] - down[at]);
  }
  Score made{Eigen::MatrixXd::Zero(k, k),
             std::vector<Eigen::VectorXd>(runs_.size(), Eigen::VectorXd::Zero(k))};
  for (std::size_t w = 0, r = 0; w < here.size(); ++w) {
    while (runs_[r] != windows_[w].run) ++r;
    const Eigen::MatrixXd slope = gauss_[w].covariance.matrixL().solve(slopes[w]);
    const Eigen::VectorXd rest = gauss_[w].covariance.matrixL().solve(here[w]);
    const double nu = experiment_.fit.degrees, n = static_cast<double>(rest.size());
    const double weight = std::isfinite(nu) ? (nu + n) / (nu + rest.squaredNorm()) : 1;
    made.information += weight * slope.transpose() * slope;
    made.of_run[r] += weight * slope.transpose() * rest;
  }
  return made;
}

}  // namespace cylon::validation
