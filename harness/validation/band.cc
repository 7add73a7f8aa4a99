#include "harness/validation/band.h"

#include "harness/validation/curves.h"
#include "harness/validation/normal.h"
#include "harness/validation/path.h"
#include "harness/validation/split.h"
#include "harness/validation/surfaces.h"
#include "reference/measured/coordinates.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace cylon::validation {
namespace {

using core::Scene, core::State, measured::Experiment, measured::Parameter;

bool is_fitted(const Fitted& fitted, const char* kind) {
  return std::ranges::find(fitted.parameters, kind, &Parameter::kind) != fitted.parameters.end();
}

// Numbers in the order: start, surfaces, parameters, all of that deviation.
std::vector<State> member(const Experiment& e, const Fitted& fitted, std::size_t frames,
                          const study::Runner& runner, Normal& normal, double deviation, Experiment& drawn) {
  Eigen::VectorXd start(e.start.cols());
  for (double& one : start) one = normal(deviation);
  const auto surfaces = drawn_surfaces(e, normal, deviation);
  Fitted own = fitted;
  Eigen::VectorXd errors(fitted.factor.cols());
  for (double& one : errors) one = normal(deviation);
  const Eigen::VectorXd by = fitted.factor * errors;
  for (Eigen::Index j = 0; j < by.size(); ++j) {
    const auto at = static_cast<std::size_t>(j);
    own.values[at] = std::clamp(own.values[at] + by[j], own.parameters[at].low, own.parameters[at].high);
  }
  drawn = with_fit(e, own);
  Scene scene =
      measured::started(drawn, measured::moved(drawn, drawn.runs[0].states.front(), drawn.start * start));
  add_surfaces(scene, surfaces);
  return predicted(drawn, scene, frames, runner);
}

study::RunFailed not_finite() {
  process::RunOutcome outcome;
  outcome.status = results::Status::fail;
  outcome.reason = "a prediction of the band is not finite";
  return {outcome};
}

}  // namespace

double level(int members) { return static_cast<double>(members - 1) / (members + 1); }

bool judged(int members) { return members == Band{}.members; }

Eigen::MatrixXd factor_of(const Eigen::MatrixXd& covariance) {
  if (covariance.rows() != covariance.cols() || !covariance.allFinite() ||
      !covariance.isApprox(covariance.transpose(), 1e-9))
    throw std::invalid_argument("it is not symmetric, or not finite");
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(covariance);
  const Eigen::VectorXd& values = eigen.eigenvalues();
  if (values.size() > 0 && values.minCoeff() < -1e-9 * values.cwiseAbs().maxCoeff())
    throw std::invalid_argument("it has a negative eigenvalue");
  return eigen.eigenvectors() * values.cwiseMax(0).cwiseSqrt().asDiagonal();
}

Experiment with_fit(const Experiment& e, const Fitted& fitted) {
  return measured::with_values(e, fitted.parameters, fitted.values);
}

Range range(const Experiment& e, std::size_t run, const study::Runner& runner, const Band& band,
            const Fitted& fitted) {
  Experiment own = with_run(e, run);
  if (is_fitted(fitted, "friction")) own.material.friction = 0;
  if (is_fitted(fitted, "restitution")) own.material.restitution = 0;
  const std::size_t frames = own.runs[0].states.size();
  std::vector<Eigen::MatrixXd> members;
  std::vector<double> factors;
  Experiment drawn;
  for (int m = 0; m < band.members; ++m) {
    Normal normal(band.seed, run, static_cast<std::uint64_t>(m));
    const double nu = band.discrepancy ? e.fit.degrees : HUGE_VAL;
    factors.push_back(std::isfinite(nu) ? std::sqrt(nu / normal.chi_squared(nu)) : 1);
    const std::vector<State> path = member(own, fitted, frames, runner, normal, factors.back(), drawn);
    if (path.size() != frames || !finite(path)) throw not_finite();
    members.push_back(curves(drawn, path, drawn.runs[0].states.front()));
  }
  Normal noise(band.seed, run, static_cast<std::uint64_t>(band.members));
  const Eigen::VectorXd deviation = curve_noise(with_fit(own, fitted));
  Range made;
  made.low = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(frames), deviation.size(),
                                       std::numeric_limits<double>::infinity());
  made.high = -made.low;
  for (Eigen::Index i = 0; i < made.low.rows(); ++i)
    for (std::size_t m = 0; m < members.size(); ++m) {
      Eigen::RowVectorXd seen = members[m].row(i);
      if (i > 0)
        for (Eigen::Index k = 0; k < seen.size(); ++k) seen[k] += noise(factors[m] * deviation[k]);
      made.low.row(i) = made.low.row(i).cwiseMin(seen), made.high.row(i) = made.high.row(i).cwiseMax(seen);
    }
  return made;
}

double share_inside(const Range& range, const Eigen::MatrixXd& measured) {
  const Eigen::Index later = measured.rows() - 1;
  const auto inside = (range.low.bottomRows(later).array() <= measured.bottomRows(later).array() &&
                       measured.bottomRows(later).array() <= range.high.bottomRows(later).array())
                          .count();
  return static_cast<double>(inside) / static_cast<double>(later * measured.cols());
}

}  // namespace cylon::validation
