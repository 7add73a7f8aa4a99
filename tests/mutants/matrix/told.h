// A simulator that simulates nothing and tells states that somebody else knows.  It takes any scene.
#pragma once

#include "tests/mutants/matrix/subject.h"

#include <functional>

namespace cylon::mutants {

/// The state of the start for ever.
Subject frozen();

/// What `states` says of the sample before; the start at t = 0.
Subject one_step_late(const std::function<core::State(double t)>& states);

/// The start, and from the first step on `first`.
Subject stopped(const core::State& first);

}  // namespace cylon::mutants
