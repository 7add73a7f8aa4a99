// What a fit knows of its parameters: errors, and what cannot be told apart.
#pragma once

#include "harness/tracking/statistics/outcome.h"
#include "harness/validation/likelihood.h"

#include <limits>
#include <span>
#include <vector>

namespace cylon::validation {

/// A direction in which the data say next to nothing: an eigenvector of D I D, where I is Fisher's information and D holds the
/// widths of the parameters' ranges.
struct Combination {
  std::vector<double> weights;  ///< Of the parameters over their ranges; unit length, the greatest positive.
  double error = 0;             ///< Standard error along it, in ranges.
};

struct Known {
  std::vector<double> error;  ///< Standard errors if the stated uncertainties are right; NaN: not known.
  std::vector<double>
      spread;  ///< The same from how much runs differ, whatever the uncertainties; NaN: not known.
  std::vector<double> alone;  ///< Standard errors if all other parameters were known: 1/sqrt(I_jj).
  double freedom = 0;         ///< Degrees of freedom of `spread`: runs less one.
  std::vector<double>
      newton;  ///< I^-1 times the gradient of log L: the step to the maximum, were log L a parabola.
  std::vector<Combination> blind;
  Eigen::MatrixXd covariance;  ///< I^-1 in what is not blind.
};

/// A combination is blind where its interval of 95 % is as wide as the ranges are: 2 * 1.96 * error >= 1.  A parameter with a
/// weight of more than 0.1 in a blind combination has no error; the others have those of I inverted without it.
///     error^2 = (I^-1)_jj;   spread^2 = (I^-1 m/(m - 1) (sum_r g_r g_r^T) I^-1)_jj
/// with g_r the gradient of run r, m runs (Huber 1967; Liang and Zeger 1986).
Known known(const Score&, std::span<const measured::Parameter>);

/// value - q error … value + q error, q the 0.975 quantile of Student's t; unbounded where the error is not known.
statistics::Interval interval(double value, double error,
                              double freedom = std::numeric_limits<double>::infinity());

}  // namespace cylon::validation
