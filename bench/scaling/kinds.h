// Scenes that grow: the kinds of scaling_bench, each with what its runs are held to.
#pragma once

#include "harness/core/scene.h"

#include <cstdint>
#include <span>

namespace cylon::bench::scaling {

/// Every run: so many steps of dt [s].
inline constexpr double dt = 1. / 60;
inline constexpr std::int64_t steps = 60;

struct Seen {
  double error = 0;           ///< In the kind's unit.
  std::int64_t contacts = 0;  ///< Pairs closer than a millimetre at the end.
};

struct Kind {
  const char *name, *what;
  const char *error, *unit;  ///< What is measured at the end.
  bool contacts;             ///< Whether bodies touch.
  core::Scene (*scene)(std::int64_t bodies);
  Seen (*look)(const core::Scene&, const core::State& end);
};

std::span<const Kind> kinds();

}  // namespace cylon::bench::scaling
