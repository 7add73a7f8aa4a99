// How far a smooth solution moves when every number of its scene is rounded: the bound that a Truth states.
#pragma once

#include "harness/core/scene.h"
#include "harness/core/truth.h"

#include <functional>

namespace cylon::exact {

/// A solution without its domain checks: a scene gives the state at any time.
using Solve = std::function<std::function<core::State(double)>(const core::Scene&)>;

/// Error of `solve(scene)` over [0, horizon].  With X the state, p the scene's numbers, eps = 2.2e-16:
///
///     error = 8 eps max_t |X| + 4 eps sum_p max_t |p dX/dp|
///
/// The first term is the rounding of the result (inside, 80 bits keep what the closed forms cancel); the
/// second is the rounding of each p to double and of each double operation that has the same effect: the
/// scene's conditioning, total angles included, as d(phase)/d(rate) = t.  The derivatives are differences
/// over 1e-12 p (next to a separatrix a longer one is none any more) at 128 times; 4 eps is eight times a rounding, which
/// leaves room for peaks between them.
core::StateError rounding_error(const core::Scene&, const Solve& solve, double horizon);

}  // namespace cylon::exact
