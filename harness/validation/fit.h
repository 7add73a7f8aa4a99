// Parameters of greatest likelihood, with intervals.
#pragma once

#include "harness/validation/information.h"
#include "harness/validation/likelihood.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cylon::validation {

/// A round of a fit, for progress and for what goes on after an interruption.
struct Evaluation {
  int round = 0;
  std::vector<double> values;
  double deviance = 0;
};

/// What a fit remembers; both may be empty.
struct Memory {
  /// The deviance that was found for these values in this round, from an earlier, interrupted fit.
  std::function<std::optional<double>(int round, std::span<const double> values)> find;
  std::function<void(const Evaluation&)> found;  ///< Called for each new one, in order.
};

struct Fit {
  std::vector<double> values;
  Known known;
  std::vector<bool> at_bound;  ///< No further from it than a difference is long: an interval means little.
  double deviance = 0;         ///< -2 log L.
  double misfit = 0;  ///< r^T C^-1 r, to be held against chi-squared with `numbers` less the parameters.
  std::size_t runs = 0, windows = 0, numbers = 0, evaluations = 0, predictions = 0;
  int rounds = 0;
  bool settled = false;  ///< The last round moved no parameter by more than a tenth of its error.
};

/// Most rounds of a fit.
inline constexpr int most_rounds = 6;

/// Rounds of: take the covariances at the parameters (Likelihood::renew), find the least deviance with them, take the information
/// there and try Newton's step; until nothing moves.  This is maximum likelihood where covariances do not depend on parameters, and
/// iterated generalised least squares where they do (Carroll and Ruppert 1988, section 2.1).
/// The optimiser is BOBYQA (Powell 2009) of NLopt, which needs no derivative and models the deviance over a region that shrinks to
/// the wanted accuracy: an engine meets contacts in whole steps, so the deviance has small jumps, at which a difference quotient
/// means nothing.  BOBYQA asks for two parameters at least; for one it is Sbplx (Rowan 1990).
/// Everything is computed in one order: the same input gives the same bits.  Throws what the likelihood does.
Fit fit(Likelihood&, const Memory& = {});

/// p of a misfit as great as that under the right model with the stated uncertainties.
double misfit_tail(const Fit&);

}  // namespace cylon::validation
