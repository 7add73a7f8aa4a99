// Scenes that differ from a given one in one number each: what rounding errors of its numbers are made of.
#pragma once

#include "harness/core/scene.h"

#include <vector>

namespace cylon::exact {

/// Every scene in which one number p of the initial state, the masses, the forces, the joints, the frame, and
/// of the shapes, planes and materials of colliding bodies, is p (1 + step); zeros stay zeros.  An entry of a
/// full inertia tensor moves by `step` times the largest entry, as an eigenvalue solver moves it.  Throws
/// core::OutOfDomain for a scene of more than some 140 bodies, whose copies would fill the memory.
std::vector<core::Scene> nudged(const core::Scene&, double step);

}  // namespace cylon::exact
