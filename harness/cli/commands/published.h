// Published numbers beside ours, digit by digit.
#pragma once

#include "harness/results/verdict.h"
#include "harness/scenario/suite.h"

#include <string>
#include <vector>

namespace cylon::cli {

/// `measured` written with as many significant digits as `published` has, in the same notation of its own.
bool same_digits(double measured, const std::string& published);

struct Reproduction {
  std::string
      text;  ///< A table: engine, step, published, here, whether every digit agrees; "" without a row.
  bool complete = true;  ///< All rows that were run agree.
};

/// The suite's published rows against the verdicts of the same engine and step.
Reproduction reproduce(const scenario::Suite&, const std::vector<results::Verdict>&);

}  // namespace cylon::cli
