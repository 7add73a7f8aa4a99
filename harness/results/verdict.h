// Numbers in, judgement out.  Knows no scene, no engine, no physics.
#pragma once

#include "harness/told/diagnostic.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cylon::results {

/// undecided: what is known of the deviation, an interval, holds what is allowed.
enum class Status { pass, low_quality, fail, undecided, unsupported, crash, timeout, non_finite, protocol };

/// "pass", "low-quality", "fail", "undecided", "unsupported", "crash", "timeout", "non-finite", "protocol".
std::string_view name(Status);
std::optional<Status> status_from(std::string_view);

/// pass: measured <= allowed; low-quality: within ten times; non-finite: NaN or infinite; else fail.
Status judge(double measured, double allowed);

/// A number that is known to lie between two.
struct Bounds {
  double low = 0, high = 0;
};

/// pass: all of it within what is allowed; fail: none of it; non-finite: NaN or infinite; else undecided.
Status judge(const Bounds&, double allowed);

/// Whether measured and allowed say anything: pass, low-quality, fail and undecided.
bool is_measured(Status);

/// log10(allowed / measured): digits won (> 0) or lost (< 0), within [-99, 99].
double digits(double measured, double allowed);

/// One row of every report.  Plain values: a report is rebuilt from stored rows without simulating.
struct Verdict {
  std::string scenario;
  std::string scenario_hash;
  std::string engine;  ///< The id asked for: "bullet/gyro=none".
  std::string version, precision, path, gyroscopic, integrator;
  std::vector<std::pair<std::string, std::string>> settings;
  std::vector<std::string> unforceable;
  bool closed_form = false;  ///< The engine takes no steps: `dt` is the grid of the samples alone.
  int substeps = 1;          ///< Parts that the engine makes of each step, each with gravity.
  double dt = 0;             ///< [s]
  std::string dt_text;       ///< As given: "1/60" or "0.001".
  std::string sampling;      ///< "every step", "every 0.1 s", "the times of the file", "the last step".
  std::string claim, observable, unit;
  std::string evidence = "verified";  ///< What the claim's truth makes of it: core::evidence.
  double measured = std::numeric_limits<double>::quiet_NaN();
  std::optional<Bounds> interval;              ///< Of `measured`, where its truth was measured: 95 %.
  std::optional<std::int64_t> first_bad_step;  ///< Of a non-finite run.
  double allowed = 0;
  double tolerance_scale = 1;    ///< By which `allowed` was multiplied; 1: a plain run.
  std::optional<double> spread;  ///< How far runs that start one ulp apart end from each other, in the
                                 ///< observable's unit; absent: not measured.
  double truth_error = 0;
  Status status = Status::fail;
  std::string tolerance_reason;
  std::string detail;                         ///< Why unsupported, how it crashed, what went wrong.
  std::vector<told::Diagnostic> diagnostics;  ///< What the engine says, as data, of how the run went.
  std::string complaints;                     ///< The end of the engine's stderr.
  Status expected = Status::pass;             ///< What expected.toml says; pass where it says nothing.
  std::optional<double>
      expected_size;           ///< What was measured when the cause was found; absent: the status says all.
  double expected_within = 1;  ///< Factor by which `measured` may differ from it.
  std::string expected_reason;
  bool version_listed = true;  ///< Whether expected.toml knows this engine version.
  double cpu_seconds = 0;      ///< As the engine's process tells it.
  bool cpu_verified = false;   ///< Whether that process's own CPU time confirms it.
  std::int64_t body_steps = 0;
  std::string reproduce;  ///< The command that gives this row again.

  /// Whether the status is the expected one; where a size is known, whether the result is neither far worse
  /// nor far better: measured within [expected_size / expected_within, expected_size expected_within].  A
  /// factor of more than ten, the width of low-quality, could hide a change of status, which then counts too.
  /// An undecided verdict contradicts none that is expected of a measured run.
  bool as_expected() const;
};

}  // namespace cylon::results
