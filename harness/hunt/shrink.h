// From a scene with a fault to the least one with the same fault: hierarchical delta debugging (Zeller and
// Hildebrandt 2002; Misherghi and Su 2006) over the parts of a scene, then over its numbers.
#pragma once

#include "harness/hunt/trial.h"

#include <functional>

namespace cylon::hunt {

/// Whether a trial still has the fault.
using Faulty = std::function<bool(const Trial&)>;

/// No single edit of the result keeps the fault: no body, joint, force, plane or material can go, no shape be a
/// simpler one, no number be zero or have fewer digits, no run be half as long.  The same on every machine that
/// answers alike.  `asked`, where given, gets how often `faulty` was called.
Trial shrink(Trial, const Faulty& faulty, int* asked = nullptr);

}  // namespace cylon::hunt
