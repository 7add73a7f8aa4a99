// The time-stepping schemes: a table of rows, each one function on the whole state (p, K, R, L).
#pragma once

#include "engine/dynamics.h"

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace cylon::engine {

/// Memory that a scheme needs within a step, kept between steps.
struct Workspace {
  explicit Workspace(const std::vector<Motion>& start);
  std::vector<Motion> stage;
  std::array<std::vector<Rate>, 4> rate;
};

/// Advances the motion from `time` by `step` [s], 0 included.
using Advance = void (*)(Dynamics&, Real time, Real step, std::vector<Motion>&, Workspace&);

struct Integrator {
  std::string_view name;
  int order = 1;               ///< Of the global error in smooth motion.
  std::string_view conserves;  ///< In words, and when it does not.
  Advance advance = nullptr;
};

/// All schemes; the first is the default.
std::span<const Integrator> integrators();

/// The scheme of that name, or null.
const Integrator* find_integrator(std::string_view name);

}  // namespace cylon::engine
