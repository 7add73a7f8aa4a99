// The forces of a scene, added to ODE's bodies before a step.
#pragma once

#include "harness/core/scene.h"

#include <vector>

struct dxBody;  // ODE's body

namespace cylon::simulators {

/// Motion of a body of the scene; where ODE has none for it, the body is locked and rests at its place.
core::BodyState ode_state(const core::Body&, dxBody*);

/// Adds a force as it is at time t [s]; ODE holds it over the next step and clears it.  Gravity is the
/// world's own and water is unsupported: nothing is added for them.  `bodies` in the scene's order.
void ode_apply(const core::Force&, const core::Scene&, const std::vector<dxBody*>& bodies, double t);

}  // namespace cylon::simulators
