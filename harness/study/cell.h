// One scenario on one engine at one step: record, measure, judge.  The unit of every study.
#pragma once

#include "harness/core/measure.h"
#include "harness/process/client.h"
#include "harness/process/engines.h"
#include "harness/results/verdict.h"
#include "harness/scenario/expected.h"
#include "harness/scenario/scenario.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace cylon::study {

/// What a cell is asked: what its scenario claims, what mechanics requires of any two runs, or what the
/// integrator's own promise requires (theory.h).
enum class Exam { claims, relations, theory };

struct Cell {
  const scenario::Scenario* scenario = nullptr;
  process::EngineChoice engine;
  double dt = 0;          ///< [s]
  std::string dt_text;    ///< As given: "1/60".
  std::string known_as;   ///< The scenario's name in expected.toml; empty: its own.
  std::string reproduce;  ///< The command that gives these rows again.
  Exam exam = Exam::claims;
  double tolerance_scale = 1;  ///< Multiplies all that is allowed, >= 0; at 0 nothing passes.
  int copies = 0;              ///< Runs that start one ulp apart, to see how far they spread.
  bool force = false;          ///< Run what the engine would refuse, where it can express it.
  /// Gets what came of the run at `dt`, and its reading for each claim where it reached the end; called by
  /// the thread that runs the cell.
  std::function<void(const process::RunOutcome&, std::span<const core::Reading>)> seen;
};

/// The steps at which a cell is recorded, and the pairs that are watched: what its claims need, no more.
struct Sampling {
  std::int64_t steps = 0;
  std::int64_t every = 1;
  std::vector<std::int64_t> at;  ///< Times of recorded truths and what else claims need, in steps.
  std::vector<core::Pair> watch;
  bool contacts = false;  ///< Those of the last step.
  std::string text;       ///< "every step", "every 25 steps"
};

/// Throws core::InputError where the step does not fit the duration, a claim's sampling, or a truth's times.
Sampling sampling(const scenario::Scenario&, double dt);

/// Runs the cell and gives a verdict for each claim of the scenario.  An engine's failure is a verdict;
/// a wrong request (a step that does not fit, an unknown option) throws core::InputError.
std::vector<results::Verdict> run(const Cell&, const process::Limits&, const scenario::Expectations&);

}  // namespace cylon::study
