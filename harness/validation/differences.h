// How long the differences are from which a fit takes derivatives of its predictions.
#pragma once

#include "harness/validation/likelihood.h"

#include <span>
#include <vector>

namespace cylon::validation {

/// A length for each parameter, and what the likelihood says with these.
struct Differences {
  std::vector<double> lengths;
  bool jumps = false;  ///< Some length had to be longer than the error of its parameter.
  Score score;
};

/// As long as the error of a parameter if the others were known, 1/sqrt(I_jj): longer differences are bent by the law of motion, and
/// would tell apart what only acts together.  But an engine that meets contacts at the ends of steps predicts with jumps.  A
/// difference of length h across a jump is jump/h, so that I_jj grows as 1/h below some length, and with it what a fit claims to
/// know.  So where a length four times as long has an I_jj that is less by more than a tenth, it is taken, up to a tenth of the range;
/// where none is even, the one to which I_jj falls least.  `from`: lengths to begin with.
Differences differences(Likelihood&, std::span<const double> values, std::span<const double> from);

}  // namespace cylon::validation
