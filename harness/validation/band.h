// The band of an engine's predictions: what uncertain starts, surfaces and fitted parameters make of one run.
#pragma once

#include "harness/study/runner.h"
#include "reference/measured/experiment.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cylon::validation {

struct Band {
  /// Predictions from starts, surfaces and parameters that differ by their uncertainty.  The range of n - 1 of them holds the n-th
  /// with probability (n - 2)/n, whatever their distribution, as each order is as likely: 39 give 95 %.  0: no band.
  int members = 39;
  std::uint64_t seed = 1;
  /// Whether all errors of a member have a factor sqrt(nu/chi-squared_nu) of its own: the discrepancy of the model that fits take, with
  /// the experiment's nu degrees of freedom.
  bool discrepancy = false;
};

/// What n members' range holds of one more of their kind: (n - 1)/(n + 1).
double level(int members);

/// Whether a share of 90 to 98 % is what such a band should hold: that of the usual number of members, 95 %, alone.
bool judged(int members);

/// Parameters as a fit found them; none: the model's own values, which are exact but for what the experiment says of its surfaces.
struct Fitted {
  std::vector<measured::Parameter> parameters;
  std::vector<double> values;
  Eigen::MatrixXd factor;  ///< L of their covariance L L^T; without columns: they are exact.
};

/// L of a covariance L L^T that may be singular.  Throws std::invalid_argument for a matrix that is no covariance.
Eigen::MatrixXd factor_of(const Eigen::MatrixXd& covariance);

/// The experiment with those values.
measured::Experiment with_fit(const measured::Experiment&, const Fitted&);

/// Least and greatest of the members' curves at each frame (curves.h), each seen with the stated noise but for the first, from which
/// they start.
struct Range {
  Eigen::MatrixXd low, high;
};

/// Of the run on one engine.  A member starts where the run does, in lengths of its own, off by a draw of the start's errors; fitted
/// parameters are drawn from their covariance and cut at their ranges, and what the experiment says of friction and restitution
/// counts only where they are not fitted.  Throws what the runner does, and study::RunFailed where a prediction is not finite.
Range range(const measured::Experiment&, std::size_t run, const study::Runner&, const Band&,
            const Fitted& = {});

/// Share of the later frames' numbers that lie inside.
double share_inside(const Range&, const Eigen::MatrixXd& measured);

}  // namespace cylon::validation
