// Every setting of a scenario run for its error, and then for its time: the rows of a work–precision table.
#pragma once

#include "harness/process/client.h"
#include "harness/results/trade.h"
#include "harness/study/ladder.h"
#include "harness/study/yardstick.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cylon::study {

/// An engine with one of its integrators: what makes a series.
struct Setting {
  process::EngineChoice engine;  ///< With its integrator stated.
  core::Integrator integrator;
  bool first_fixed = false;  ///< It is the engine's first integrator of fixed steps.
  bool asked = false;        ///< The user named it: what it cannot do is an error, not a row less.
  bool by_itself =
      false;  ///< It is what the engine takes where nothing is said: a path may then take another.

  /// What is asked of the engine.
  std::string integrator_asked() const { return by_itself ? std::string() : integrator.name; }
};

/// One finished run as it is remembered: the point without its times, and what the engine said of itself.
struct Ran {
  results::TradePoint point;
  std::string integrator, version, precision, path, gyroscopic;
  int order = 0;  ///< Of the integrator; 0: the engine never loaded the scene.
  bool closed_form = false;
  int substeps = 1;        ///< Of each step.
  double cpu_seconds = 0;  ///< Of the recorded run: a first guess of its time.
};

/// What has been done before: so that an interrupted sweep goes on.  The default knows and keeps nothing.
class Memory {
 public:
  virtual ~Memory() = default;
  virtual std::optional<Ran> find(const Setting&, std::int64_t steps, double tolerance);
  virtual void keep(const Setting&, const Ran&);
  virtual std::optional<process::Repetition> find_time(const Setting&, const results::TradePoint&, int round);
  virtual void keep_time(const Setting&, const results::TradePoint&, int round, const process::Repetition&);
};

struct SweepOptions {
  std::vector<double> tolerances;  ///< Of integrators that control their error, from coarse to fine.
  std::optional<std::size_t> by;   ///< The measure that decides; the yardstick's principal one otherwise.
  int workers = 1;                 ///< Runs at one time, while errors are measured.
  int rounds = 3;                  ///< Of timing; 0: no times.
  std::vector<double> reach;       ///< Time only the coarsest points that meet one of them; none: all.
  process::Limits limits;
};

/// "in-house bm6", "bullet/gyro=none": engine and integrator as a table shows them.
std::string label(const results::TradeSeries&);

/// Called after each run, one at a time: the series, and whether it was a timing.
using SweepStep = std::function<void(const Setting&, const results::TradePoint&, bool timing)>;

/// One run measured by the yardstick: an engine's failure is a point without errors.  Throws core::InputError
/// for a setting that the engine calls impossible, process::Interrupted.
Ran measure_run(const Setting&, const scenario::Scenario&, const Yardstick&, std::int64_t steps,
                double tolerance, const process::Limits&);

/// The errors of all settings over the ladder, series by series in the order of the settings, `workers` at
/// one time.  A series ends early at two runs that time out, where no run can do better (unsupported), and
/// after two steps that no longer lower an error below 1e-8 (single precision: 1e-3); none of that depends on
/// times. A default setting that the engine calls impossible is taken out of `settings`, which stay side by
/// side with the series.
results::TradeTable sweep_errors(const scenario::Scenario&, const Yardstick&, const Ladder&,
                                 std::vector<Setting>& settings, const SweepOptions&, Memory&,
                                 const SweepStep&);

/// The times of all points that passed (of those that options.reach asks for), one run at a time: round r of
/// every point before round r + 1, each in a worker of its own whose first run only warms it; repetitions
/// until 20 ms have passed, of which the least counts.  An integrator that controls its error may solve while
/// it loads, so its load is part of its cost; of all others the steps alone are.
void sweep_times(results::TradeTable&, const scenario::Scenario&, const std::vector<Setting>&,
                 const SweepOptions&, Memory&, const SweepStep&);

/// Marks the front of each build (results/build.h) and whom each other point of it is dominated by, from costs and errors by
/// `table.by`; an error of 1 or more is no point.
void mark_front(results::TradeTable&);

}  // namespace cylon::study
