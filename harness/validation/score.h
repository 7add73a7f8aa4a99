// How well an engine predicts a measured motion: each run is started from its first frame and compared with the rest of
// it.  Validation, as against verification: a model of a real thing is judged here, with its parameters, and never an engine
// alone.
#pragma once

#include "harness/study/runner.h"
#include "harness/tracking/statistics/outcome.h"
#include "harness/validation/band.h"
#include "reference/measured/experiment.h"

#include <limits>
#include <string>
#include <vector>

namespace cylon::validation {

inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// What one run says.
struct RunScore {
  std::string run;
  std::string failure;          ///< Why there is no prediction; the rest is not known then.
  double distance = not_known;  ///< Between predicted and measured centre in the last frame [m].
  double angle = not_known;  ///< Of the turn between predicted and measured orientation there, 0 … pi [rad].
  bool same_side = false;    ///< The body axis, of six, that is nearest to up there is the measured one.
  double impact =
      not_known;  ///< Predicted less measured time of the first touch; not known where one has none [s].
  double place = not_known;  ///< Between the centres at their first touches, along the plane [m].
  /// Share of the energy that is lost by 0.1 s after the first touch, predicted less measured; not known where one has none.
  double loss = not_known;
  /// Share of its energy that each touch takes, predicted less measured; NaN where either is not known (touches.h).
  std::vector<double> touch_losses;
  double covered =
      not_known;  ///< Share of measured coordinates of later frames inside the band; not known without one.
};

/// One run on one engine, with the parameters of a fit where there is one.
RunScore score(const measured::Experiment&, std::size_t run, const study::Runner&, const Band&,
               const Fitted& = {});

/// A number over all runs, with the interval that holds it in 95 of 100 such experiments.
struct Estimate {
  double value = not_known;
  statistics::Interval interval;
  std::size_t runs = 0;  ///< That it is of.
};

/// What is said where an interval is held against a range.
enum class Answer { inside, outside, undecided };
Answer answer(const statistics::Interval&, double low, double high);
const char* name(Answer);  ///< "yes", "no", "undecided".

/// Mean of shares inside the bands of runs, those that are finite; frames of a run hang together, and runs do not.
Estimate covered(const std::vector<double>& shares);
/// Whether that is 90 to 98 %.
Answer band_answer(const Estimate& covered);

struct Summary {
  std::size_t runs = 0, failed = 0;
  std::string first_failure;
  Estimate distance;                   ///< Median [m].
  Estimate angle;                      ///< Median [rad].
  Estimate same_side;                  ///< Share.
  Estimate impact;                     ///< Median of the absolute value [s].
  Estimate place;                      ///< Median [m].
  Estimate loss;                       ///< Median, with its sign.
  std::vector<Estimate> touch_losses;  ///< The same of each touch, of the runs in which it is known.
  Estimate covered;                    ///< Mean share inside the band.
  Answer band = Answer::undecided;     ///< Whether the share covered is 90 to 98 %.
};

Summary summary(const std::vector<RunScore>&);

/// Which of two engines does better, by the exact sign test over the runs that both have a number of.
struct Better {
  std::size_t one = 0, other = 0;  ///< Runs in which it does.
  double p = 1;                    ///< Adjusted by Holm over all comparisons of a report.
  /// inside: the first engine does better; outside: the other one; undecided: p > 0.05.
  Answer answer = Answer::undecided;
};

/// The first engine against each later one, by a number for each run of which less is better; not finite: there is none.
std::vector<Better> better(const std::vector<std::vector<double>>& engines);

/// The same by the distance at rest.
std::vector<Better> nearer(const std::vector<std::vector<RunScore>>& engines);

}  // namespace cylon::validation
