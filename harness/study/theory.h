// What an integrator promises by the order or the error bound that it states, and whether a run keeps it.  A
// scenario says how fast its motion goes (`[theory]`); the bound follows from that, for every engine by its own
// promise: one of first order is not asked for more, and one that bounds its error is not let off with less.
#pragma once

#include "harness/core/recording.h"
#include "harness/study/cell.h"

#include <functional>
#include <string>
#include <vector>

namespace cylon::study {

/// What an engine says of its errors on the terms that it ran with.
struct Promise {
  int order = 1;           ///< Of the global error in smooth motion.
  bool adaptive = false;   ///< Bounds its error and chooses its steps.
  double tolerance = 0;    ///< Of an adaptive integrator, relative.
  bool each_step = false;  ///< Whether that is of each step alone.
};
Promise promise_of(const core::Engine&, const core::Terms&);

/// The bound on the error of a quantity, in a run of step h over a time T.  With p the order, W the fastest
/// rate of the motion, M what the motion itself makes of an error, S the claim's scale:
///
///   M S (e^(d x) - 1), x = (W h)^p W T   of a fixed step h: a part (W h)^(p+1) a step, compounded;
///   10 tolerance M S                     of an integrator that bounds its error; it may misjudge by ten;
///   10 tolerance M S W T                 of one that bounds the error of each of its steps;
///
/// d is 2 for energies and angular momenta, products of two quantities that err, else 1.  p is 1 for fixed
/// steps where forces jump.  Rounding is allowed in addition: M times ten roundings a step, all of one
/// sign, of the largest value or, where that is more, of the state that the value follows from.  So is the truth's own error.
struct Bound {
  double allowed = 0;   ///< [the observable's unit]
  double rounding = 0;  ///< The part of it that is rounding.
  std::string reason;   ///< The formula with its numbers.
};

/// Requires scenario.theory; `run`: the scenario's at `step`, of which the engine and its terms are read.
Bound bound_of(const scenario::Scenario&, const core::Claim&, double step, const core::Recording& run);

/// Of one claim by theory: its value, or its order.
struct TheoryFinding {
  std::string claim;  ///< "theory: position follows kepler", "theory: order of position follows kepler"
  std::string observable, unit;
  double measured = 0, allowed = 0, truth_error = 0;
  std::string reason, detail;
  bool binds = true;  ///< False where the bound is as large as the claim's scale: nothing could break it.
};

/// The scenario as far as its theory goes, with the claims that theory speaks of: those of no event, measured
/// by their largest or last deviation.  Requires scenario.theory.
scenario::Scenario cut_to_theory(const scenario::Scenario&);

/// `run(k)`: a recording of the cut scenario at step/2^k, asked for with k = 0, and 1 and 2 where an order
/// shows.  The order of a truth-following claim is asked of fixed steps in smooth motion, where the bound is
/// below a tenth of the scale and the errors are above rounding; it must not fall short of the promise by more
/// than a half.  Throws RunFailed where an engine states a tolerance that is no number above 0.
std::vector<TheoryFinding> judge_by_theory(const scenario::Scenario& cut, double step,
                                           const std::function<core::Recording(int k)>& run);

/// The cell's rows by theory; none where the scenario states no theory.
std::vector<results::Verdict> theorize(const Cell&, const process::Limits&, const scenario::Expectations&);

}  // namespace cylon::study
