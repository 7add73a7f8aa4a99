// What `cylon track compare` and `cylon track gate` have in common.
#pragma once

#include "harness/cli/selection.h"
#include "harness/results/comparison.h"
#include "harness/tracking/track.h"

#include "harness/cli/parser.h"

#include <string>
#include <vector>

namespace cylon::tracking {

struct CompareRequest {
  cli::Request cells;  ///< Which scenarios, engines, steps; engines of the user's own.
  std::string baseline, candidate, instructions = "auto", store;
  std::vector<std::string> baseline_workers;
  double tau = 0.02, timeout = 60;
  int max_pairs = 40;
  bool strict = false, no_time = false, gate = false;
  std::string json, junit, markdown;
};

void add_compare_options(cli::App&, CompareRequest&);

/// The whole command: compares, prints, writes the reports; returns the exit code.
int compare(const cli::Context&, const CompareRequest&);

/// Whether no cell was compared: each is missing on a side or unsupported.
bool nothing_compared(const results::ComparisonReport&);

/// 1 where a cell regressed; 4 where nothing was compared; 3 under `strict` where a cell is inconclusive or
/// missing on a side, or the environment is unreliable; else 0.
int exit_code(const results::ComparisonReport&, bool strict);

}  // namespace cylon::tracking
