// Where a scene names a joint makes no difference to what the joint forbids, and shall make none to the motion.
#pragma once

#include "engine/model.h"

namespace cylon::engine {

/// The same joint at the point that its bodies alone decide, among those that it keeps as well as its own: on its axis, or
/// anywhere where it lets nothing turn.  Bounds from its arms, rounds that end early, errors of a step and loads that nothing
/// decides are then the same whatever point was named, and from whichever of the two bodies.
///   p = (c_a/m_a + c_b/m_b)/(1/m_a + 1/m_b)
/// with the centres c; along directions in which the bodies slide p = c of `body`, which stays so while they do.
Joint at_centres(Joint, const Model&);

}  // namespace cylon::engine
