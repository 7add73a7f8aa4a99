// Recording -> number.  Reads Scene and Recording; knows no engine.
#pragma once

#include "harness/core/claim.h"
#include "harness/core/recording.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cylon::core {

/// A claim's deviation at each of its samples.
struct Series {
  std::vector<double> time;       ///< [s]
  std::vector<double> deviation;  ///< |Q(t) - Q*(t)|, |Q(t) - Q(0)|, what is missing of `at_least` so far, or
                                  ///< the rise or fall of a one-sided claim, in the observable's unit.
};

/// How many samples after the start a claim looks at, at least: of fewer the start alone would decide.  A mean square gives
/// its last sample no weight.
inline int samples_needed(const Claim& claim) { return claim.reduction == Reduction::mean_square ? 2 : 1; }

/// The step by which a least change must show: the first that is not before the claim's `until`.
std::int64_t last_step_of_change(const Claim&, double dt);

/// The samples that the claim asks for (its `sample`, its `until`, its truth's own times).
Series deviation(const Claim&, const Scene&, const Recording&);

/// Slope of log(error) against log(dt), least squares.
double observed_order(std::span<const double> dt, std::span<const double> error);

/// One run against a claim: what its verdict is made of, and what its error curve shows.
struct Reading {
  Series series;       ///< Empty for events.
  double largest = 0;  ///< largest_value(), where an order needs it.
  double allowed = 0;  ///< allowed() at the engine's precision; the bound that an order sets is not in it.
};

/// absolute + relative x scale + roundings x epsilon x size, or what the level of a test of chance allows; not
/// the bound that an order sets.  `epsilon`: of the precision of whoever is judged (engine.h).
double allowed(const Claim&, const Scene&, double duration, double epsilon);

/// The largest bound that tells a motion from another: a tenth of the claim's scale [unit of the measured number]; of a mean of
/// squares the square of that, and of a rate that over the time.  Infinite where the claim's bound is
/// not a number of its own (an order, a level), its truth was measured, or no motion is known to take the scale from.
double widest(const Claim&, const Scene&, double duration);

Reading read(const Claim&, const Scene&, const Recording&, double duration);

struct Measured {
  double value = 0;  ///< In the observable's unit (order: a number; rate: unit/s).
  std::optional<std::pair<double, double>> interval;  ///< Of the value, at 95 %: uncertain.h.
  double allowed = 0;
  std::string detail;   ///< What the number alone does not say: a missing event, a lost order.
  bool broken = false;  ///< `detail` is a failure, whatever the number.
  bool unanswered =
      false;  ///< The engine does not tell what is asked; `detail` says what.  There is no number.
};

/// The step of the first recorded state with a number that is not finite; nothing where all are.
std::optional<std::int64_t> first_bad_step(const Recording&);

/// How many runs, each at half the step of the one before, the claim needs: 1 or 3.
int runs_needed(const Claim&);

/// Recordings at dt, dt/2, … as runs_needed says; `duration` is the scenario's [s]; `first`: the first of
/// them, read.
Measured measure(const Claim&, const Scene&, std::span<const Recording>, double duration,
                 const Reading& first);
inline Measured measure(const Claim& claim, const Scene& scene, std::span<const Recording> recordings,
                        double duration) {
  return measure(claim, scene, recordings, duration, read(claim, scene, recordings.front(), duration));
}

}  // namespace cylon::core
