// The prediction horizon of a chain: the time until a predicted angle is off by a given amount, and what the uncertainty of the
// start alone would make of it.
#pragma once

#include "harness/study/runner.h"
#include "harness/validation/score.h"
#include "reference/measured/experiment.h"

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace cylon::validation {

struct Horizon {
  std::string run, failure;  ///< Why there is no prediction; the rest is not known then.
  double held =
      not_known;  ///< First time at which some angle is off by more than the bound; infinite: none is [s].
  double expected =
      not_known;  ///< The median of it if the start's covariance were all that is wrong; infinite: later than the run [s].
  double exponent =
      not_known;  ///< Of the growth of errors of the start, over the run or until `expected` [1/s].
  double covered =
      not_known;  ///< Share of measured angles of later frames inside the band; not known without one.
};

/// The run from its first frame.  With d_i the change of the angles by the i-th column of the factor L of the start's covariance,
/// from central differences of a hundredth of it, the angles err by N(0, sum d_i d_i^T), and the greatest standard deviation sigma
/// reaches bound/0.6745 where its angle is off in half of all cases.  The exponent is ln(|D(T)|/|D(0)|)/T, |D| the greatest singular
/// value of the change of the angles by the angles of the start.
Horizon horizon(const measured::Experiment&, std::size_t run, const study::Runner&, double bound = 0.1);

/// The run with the parameters of a fit, where there is one, and its band.
Horizon horizon(const measured::Experiment&, std::size_t run, const study::Runner&, const Band&,
                const Fitted&);

/// Those of some runs without a band, so many at one time.
std::vector<Horizon> horizons(const measured::Experiment&, std::span<const std::size_t> runs,
                              const study::Runner&, int jobs);

/// Medians over runs that have a prediction; a run that holds to its end counts as longer than any other.
struct HorizonSummary {
  std::size_t runs = 0, failed = 0, to_the_end = 0;  ///< Those that hold to the end of the data.
  std::string first_failure;
  Estimate held, expected, exponent;
  Estimate covered;                 ///< Mean share inside the band.
  Answer band = Answer::undecided;  ///< Whether the share covered is 90 to 98 %.
};

HorizonSummary summary(const std::vector<Horizon>&);

}  // namespace cylon::validation
