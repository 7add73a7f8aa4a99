// What `cylon fit` found: text and JSON.
#pragma once

#include "harness/validation/fit.h"
#include "harness/validation/horizon.h"
#include "harness/validation/score.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace cylon::cli {

/// One engine, fitted on some runs and judged on others.
struct FitRow {
  std::string engine, failure;         ///< Why there is no fit; the rest is not known then.
  std::vector<std::string> fitted_on;  ///< Names of runs.
  std::vector<std::string>
      fitted_data;  ///< Their hashes: what was seen is known again in another file, under another name.
  validation::Fit fit;
  std::vector<std::string> judged_on;  ///< Names of runs that the likelihood was taken of; may be empty.
  std::string judge_failure;           ///< Why they could not be judged; the fit is known all the same.
  std::size_t left_over = 0;           ///< Frames at the ends of runs that make no window.
  std::vector<double> deviances;       ///< Of those, with the fitted parameters.
  /// Of the judging runs, with the model's own parameters and the fitted ones: of a free body, or of a chain.
  std::vector<validation::RunScore> before, after;
  std::vector<validation::Horizon> horizon_before, horizon_after;
};

std::string told(const FitRow&, const std::vector<measured::Parameter>&);
nlohmann::ordered_json to_json(const FitRow&, const std::vector<measured::Parameter>&);

/// An engine's rows of all folds together: what they say of runs that they were not fitted on.
struct Judged {
  std::string engine;
  std::vector<double> deviances;  ///< By run, in the order of the table; NaN: not judged.
  std::vector<validation::RunScore> before, after;
  std::vector<validation::Horizon> horizon_before, horizon_after;
};

std::string told(const Judged&);
nlohmann::ordered_json to_json(const Judged&);

/// The first engine against each later one, by the likelihood of runs that neither was fitted on: exact sign test and Holm.
struct Likelier {
  std::string one, other;
  validation::Better by;  ///< `one` counts runs that are likelier under the first engine.
};
std::vector<Likelier> likelier(const std::vector<Judged>&);
std::string told(const Likelier&);
nlohmann::ordered_json to_json(const Likelier&);

}  // namespace cylon::cli
