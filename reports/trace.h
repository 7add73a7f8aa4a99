// What a run looked like, thinned to what an eye can follow: frames for a picture, curves for a plot.
// Knows no file and no engine; judging reads the core::Recording, never this.
#pragma once

#include "harness/core/measure.h"
#include "harness/core/recording.h"
#include "harness/core/trajectory.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cylon::reports {

/// How much of a run a trace keeps.
struct TraceLimits {
  std::size_t frames = 300;             ///< Of a motion, at most.
  std::size_t frames_bodies = 300'000;  ///< Frames x bodies, at most.
  std::size_t points = 300;             ///< Of a curve, at most.
};

/// The motion that a truth requires.
struct Ghost {
  core::Trajectory motion;
  std::string follows, source;
};

/// Where a claim's deviation first exceeded what is allowed, or was not finite.
struct Violation {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  double value = 0;  ///< In the observable's unit.
};

/// A claim's deviation over time.  Of several samples that share a point the worst stands, at its own time;
/// the last sample stands for itself.
struct ErrorCurve {
  std::string claim, unit;
  double allowed = 0;  ///< Of the claim's number; a line in the plot where that is the largest deviation.
  std::vector<double> time, value;
  std::optional<Violation> first_violation;
};

/// A total of all bodies over time, in the frame of the scene.
struct TotalCurve {
  std::string name, unit;
  std::string component;  ///< "x", "y", "z", or "".
  std::vector<double> time, value;
};

/// An event, in words.
struct TraceEvent {
  double time = 0;  ///< [s]
  std::string kind, what;
};

struct Trace {
  std::string scenario, engine, integrator, dt_text;  ///< Whose run it is; the caller fills them in.
  core::Trajectory motion;
  /// Of the first claim with a truth that is known at any time, at the frames' times; else of one that
  /// follows recorded data, at those of its times that are frames.
  std::optional<Ghost> ghost;
  std::vector<ErrorCurve> errors;
  std::vector<TotalCurve> totals;
  std::vector<TraceEvent> events;  ///< At most `points`.
  std::vector<std::string> remarks;
};

/// The trace of a recording and its reading for each claim.  Totals are energy, kinetic energy, momentum and
/// angular momentum about the origin, those that the scene has; errors those of claims over states (events
/// have none).
Trace trace(const core::Scene&, const std::vector<core::Claim>&, std::span<const core::Reading>,
            const core::Recording&, const TraceLimits& = {});

}  // namespace cylon::reports
