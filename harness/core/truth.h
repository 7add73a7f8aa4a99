// The state that the laws of mechanics require, independent of any simulator.
#pragma once

#include "harness/core/event.h"
#include "harness/core/scene.h"

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace cylon::core {

/// A bound on the error of every body's state, at any time up to the horizon asked for.
struct StateError {
  double position = 0;          ///< [m]
  double velocity = 0;          ///< [m/s]
  double orientation = 0;       ///< [rad]
  double angular_velocity = 0;  ///< [rad/s]
  double time = 0;              ///< Of events [s].
};

struct Truth {
  std::function<State(double t)> state;  ///< t in [s], 0 <= t <= horizon.
  /// Up to the horizon, in order of time.  Of a kind either all, with all that it has, or none: those are
  /// then found in the states (with_events), so that only closed forms need to stand here.
  std::vector<Event> events;
  /// Where that list ends, if before the horizon: infinitely many bounces, data without events [s].
  double events_until = std::numeric_limits<double>::infinity();
  StateError error;                                          ///< Bound on this truth's own error.
  std::string source;                                        ///< Where the formula or the data come from.
  double horizon = std::numeric_limits<double>::infinity();  ///< [s]
  std::vector<double> times;  ///< Recorded data: the only times at which it is known.  Empty: any.
  /// Recorded data may lack these of a body that moves; its states then hold what the scene starts with.
  bool knows_velocity = true, knows_orientation = true, knows_angular_velocity = true;
};

/// A truth was asked for a scene outside its domain; the message says which condition failed.
struct OutOfDomain : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

}  // namespace cylon::core
