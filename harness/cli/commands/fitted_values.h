// What `cylon fit --json` found, read back for predictions of runs that it did not see.
#pragma once

#include "harness/validation/band.h"

#include <set>
#include <string>
#include <vector>

namespace cylon::cli {

/// One fit of one engine.
struct FoundFit {
  std::string engine, failure;  ///< Why there is none.
  std::set<std::string> seen;   ///< Hashes of the runs that it was fitted on.
  validation::Fitted fitted;
};

/// The fits of a file, with parameters of the experiment.  `covariance`: each must have one, as a band needs it.
/// Throws core::InputError for what is no such file, a parameter that the experiment has not, a value outside its range, and, with
/// `covariance`, for parameters that the fit could not tell apart.
std::vector<FoundFit> read_fits(const std::string& file, const measured::Experiment&, bool covariance);

/// The engines of the fits, each once, in their order.
std::vector<std::string> engines_of(const std::vector<FoundFit>&);

/// The first fit of the engine that did not see the run: that of the fold that left it out.  Null: it was seen by all, or there is none.
const FoundFit* unseen(const std::vector<FoundFit>&, const std::string& engine, const measured::Run&);

}  // namespace cylon::cli
