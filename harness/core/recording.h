// What a run leaves behind.  Everything downstream reads a Recording, never a Simulator.
#pragma once

#include "harness/core/engine.h"
#include "harness/core/event.h"
#include "harness/core/scene.h"
#include "harness/told/diagnostic.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cylon::core {

/// Number of whole steps in a duration; throws std::invalid_argument, naming the nearest step that
/// fits, unless duration/dt is whole within 1e-9.
std::int64_t whole_steps(double duration, double dt);

/// Steps between recorded states: 1 while bodies x steps <= 10^6, else the least stride that gives
/// at most 200 evenly spaced samples plus start and end.  `sample` in [s] (a multiple of dt) or 0 for this
/// rule.
std::int64_t sampling_stride(std::size_t bodies, std::int64_t steps, double dt, double sample);

/// States at t = step * dt: the start, multiples of the stride, and the end.
struct Recording {
  double dt = 0;                    ///< [s]
  std::vector<std::int64_t> steps;  ///< Ascending, from 0.
  std::vector<State> states;        ///< One per step kept.
  std::vector<Event> events;
  std::optional<std::vector<Contact>> contacts;    ///< Of the last step; absent: not asked for, or not told.
  std::optional<std::vector<Reaction>> reactions;  ///< Of the joints, likewise.
  Engine engine;              ///< Who ran it: name, version, precision, and the integrator that ran.
  Terms terms;                ///< With what settings.
  double cpu_seconds = 0;     ///< Thread CPU time of the steps alone, as the engine's process tells it.
  bool cpu_verified = false;  ///< Whether that process's own CPU time confirms it.
  std::vector<std::string> remarks;           ///< What the engine says that a user must know of the run.
  std::vector<told::Diagnostic> diagnostics;  ///< The same as data, from engines that tell it so.
  std::vector<Work> works;  ///< Of each force over the whole run, where the engine accounts it.
  std::string complaints;   ///< The end of what the engine wrote to stderr.

  double time(std::size_t sample) const { return static_cast<double>(steps[sample]) * dt; }
};

}  // namespace cylon::core
