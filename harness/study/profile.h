// What one build gives for a cell that repeats bit for bit: errors, orders, hashes and counts.  One run is
// enough.
#pragma once

#include "harness/results/comparison.h"
#include "harness/study/cell.h"
#include "harness/study/exact_facts.h"
#include "harness/study/instructions.h"

#include <limits>
#include <string>
#include <vector>

namespace cylon::study {

struct ClaimProfile {
  std::string claim, unit;
  double error = std::numeric_limits<double>::quiet_NaN();  ///< What the claim measures, in `unit`.
  double floor = 0;                                         ///< What rounding alone may make of it.
  /// log2(e(dt)/e(dt/2)) of the largest deviation; NaN where the integrator chooses its steps, an error is
  /// at the floor, or the claim is of an event.
  double order = std::numeric_limits<double>::quiet_NaN();
};

struct Profile {
  results::Status status = results::Status::pass;  ///< Of the run; the claims' verdicts are not asked.
  std::string reason;                              ///< Empty when it passed.
  std::string version;                             ///< Of the engine, where it ran.
  ExactFacts facts;
  std::vector<ClaimProfile> claims;  ///< In the order of the scenario; empty unless it passed.
  InstructionCount instructions;
};

/// Runs the cell on `engine` at dt, dt/2, and dt/4 where a claim needs it.
///
/// floor = truth_error + 64 eps sqrt(n) S (+ 4 times the spread of two runs that start one ulp apart, where
/// the scenario is tagged chaos), with eps of the engine's precision, n = duration/dt and S the scale of the
/// claim (1 rad for angles): a change of rounding alone, another order of the same sums, stays below it.
/// Throws what process::run throws.
Profile profile(const scenario::Scenario&, const process::EngineChoice&, double dt, Counter,
                const process::Limits&);

/// What the rules of statistics::metric_rules say of each metric that both have.  An order counts where the
/// baseline's is one: within 1/4 of a whole number >= 1.
std::vector<results::ComparedMetric> compare_profiles(const Profile& baseline, const Profile& candidate);

}  // namespace cylon::study
