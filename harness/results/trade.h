// Speed against accuracy: what was measured of one scenario, setting by setting.  Plain values, from which
// every report is made.  Knows no engine.
#pragma once

#include "harness/results/verdict.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace cylon::results {

/// A kind of error, by which every run of a scenario is measured.
struct TradeMeasure {
  std::string name;       ///< "trajectory", "position", "energy", "events", …
  std::string unit;       ///< Of the value; the error itself is value/scale.
  double scale = 0;       ///< By which a value becomes an error; of angles 1 rad; 0: each part by its own.
  std::string against;    ///< "heavy_top", "its start", "in-house auto at 1e-11 (uncertified)"
  double resolution = 0;  ///< Relative error of what it is measured against.
};

/// One run: an engine, an integrator, a step or a tolerance.
struct TradePoint {
  std::int64_t steps = 0;
  double dt = 0;         ///< Step [s]; of an integrator that controls its error the grid of its samples.
  std::string dt_text;   ///< As --dt takes it: "5/1248".
  double tolerance = 0;  ///< Of an integrator that controls its error; else 0.
  Status status = Status::pass;
  std::string reason;          ///< Where it did not pass.
  std::vector<double> errors;  ///< Relative, by measure, max over time; empty where it did not pass.

  // Times, which differ from run to run; NaN: not measured.
  double step_seconds = std::numeric_limits<double>::quiet_NaN();  ///< CPU time of all steps.
  double load_seconds = std::numeric_limits<double>::quiet_NaN();  ///< CPU time of taking the scene.
  double cost = std::numeric_limits<double>::quiet_NaN();          ///< CPU seconds per simulated second.
  bool on_front = false;
  std::string dominated_by;  ///< A point of its build's front: "in-house bm6 at 5/1248"; empty: nobody.
};

/// The runs of one engine with one integrator, from the coarsest step to the finest.
struct TradeSeries {
  std::string engine;  ///< Its id: "bullet/gyro=none".
  std::string integrator, version, precision, path, gyroscopic;
  int declared = 0;          ///< The order that the engine declares; 0: it did not load.
  bool adaptive = false;     ///< The integrator takes a tolerance in place of a step.
  bool closed_form = false;  ///< The engine takes no steps: a step is the grid of the samples alone.
  int substeps = 1;          ///< Parts that the engine makes of each step, each with gravity.
  double order = std::numeric_limits<double>::quiet_NaN();  ///< Observed; NaN: none.
  double floor = std::numeric_limits<double>::quiet_NaN();  ///< Error that a finer step does not lower; NaN:
                                                            ///< none seen.
  double floor_from = 0;                                    ///< The coarsest step at the floor [s].
  bool rounding = false;  ///< The floor is as low as rounding, or as the truth's own error.
  std::string reason;     ///< Why there is no point at all; empty: there are.
  std::string cause;      ///< The known cause of its errors (docs/causes.md); empty: none.
  std::vector<TradePoint> points;
};

struct TradeTable {
  std::string scenario, scenario_hash;
  double duration = 0;  ///< [s]
  std::int64_t bodies = 0;
  std::string truth;        ///< What trajectories are measured against, in words.
  std::size_t samples = 0;  ///< Times at which they are, after the start.
  std::vector<TradeMeasure> measures;
  std::size_t by = 0;  ///< The measure that decides orders and the front.
  double target = 0;   ///< The error that the user asks for; 0: none.
  std::vector<TradeSeries> series;
};

}  // namespace cylon::results
