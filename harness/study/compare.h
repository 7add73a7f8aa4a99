// Whether one build of an engine is slower or less accurate than another, cell by cell, on a machine that is
// busy.
#pragma once

#include "harness/results/comparison.h"
#include "harness/study/cell.h"
#include "harness/study/instructions.h"
#include "harness/study/profile.h"
#include "harness/study/sampler.h"
#include "harness/study/side.h"
#include "harness/tracking/statistics/paired_rule.h"

#include <functional>
#include <string>
#include <vector>

namespace cylon::study {

struct CompareOptions {
  statistics::PairedRule rule;
  bool time = true;
  /// Many cells and one decision: every cell is sampled with alpha / m and judged by Holm's adjustment, so
  /// that one false alarm in the whole gate has the probability alpha.
  bool gate = false;
  SampleRule sample;
  Pinning pinning;  ///< Of the timed workers.
  Counter counter = Counter::off;
  process::Limits limits;
};

/// Says what is going on: "timing bounce/in-house@0.001, pair 12 of 40".
using CompareProgress = std::function<void(const std::string&)>;

/// Compares every cell, its engine as the candidate's; `reproduce` is the cell's own.
///
/// Where both workers are the same file by content, libraries included, the cell is skipped.  Else first what
/// repeats bit for bit (profile.h), then the times, pair by pair in fresh processes.  Beside the first cell
/// that is timed the baseline is timed against itself, its pairs between those of the cell; should the rule
/// tell it from itself, no time of this run is believed.  A candidate that fails where the baseline does not
/// has regressed. After an interruption no further cell is compared and no further time taken; the report says so. Throws
/// what else process::run throws.
results::ComparisonReport compare(const std::vector<Cell>&, const Side& baseline, const Side& candidate,
                                  const CompareOptions&, const CompareProgress&);

/// A row with the cell's names and nothing compared yet.
results::Comparison open_comparison(const Cell&);

/// Whether both builds ran to the end, so that there is something to compare; else the row says what is the
/// matter.
bool both_ran(results::Comparison&, const Profile& baseline, const Profile& candidate);

/// What an interruption leaves of a row: its results without times where it has them, else a row that is skipped.
void leave_out(results::Comparison&);

/// Holm's adjustment over the cells that were timed, and the findings by it.
void adjust(std::vector<results::Comparison>&, double alpha);

/// How the times of an unreliable environment are called, and the cells' findings over all their metrics.
void conclude(results::ComparisonReport&);

}  // namespace cylon::study
