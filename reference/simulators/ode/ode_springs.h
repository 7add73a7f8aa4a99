// Springs of a scene as soft joints of ODE, which are implicit: stable at any stiffness.
#pragma once

#include "harness/core/scene.h"

#include <vector>

struct dxBody;   // ODE's body
struct dxWorld;  // and its world

namespace cylon::simulators {

/// Whether a spring is too stiff for a force that is held over a step: dt^2 k + dt c > m, with the mass of
/// the lighter end.  (A body on an explicit spring diverges beyond dt^2 k = 4 m.)
bool ode_stiff(const core::Spring&, const core::Scene&, double dt);

/// Adds the joint whose force at the end of a step is that of the spring:
///   ERP = dt k/(dt k + c),  CFM = 1/(dt k + c).
/// A rest length > 0 makes it a distance joint.  With none it is a ball joint, which damps motion across the
/// spring as well.  Requires dt k + c > 0.  `bodies` in the scene's order.
void ode_add_spring(dxWorld*, const core::Spring&, const core::Scene&, const std::vector<dxBody*>& bodies,
                    double dt);

}  // namespace cylon::simulators
