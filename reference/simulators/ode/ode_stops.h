// Limits and dry friction of a joint's coordinate, as ODE has them: stops with a restitution, and a motor at rest
// with a largest force (ode/common.h, D_ALL_PARAM_NAMES).
#pragma once

#include "harness/core/scene.h"

#include <ode/common.h>

#include <optional>

namespace cylon::simulators {

/// `reversed`: ODE's first body is the joint's `to`, and its coordinate counts the other way.
/// `erp`: share of what goes past a stop that is corrected in a step; nothing: that of the world.
void ode_limit_hinge(dJointID, const core::Joint&, bool reversed, std::optional<double> erp);
void ode_limit_slider(dJointID, const core::Joint&, bool reversed, std::optional<double> erp);
/// ODE's second group of parameters is that of the angle.
void ode_limit_piston(dJointID, const core::Joint&, bool reversed, std::optional<double> erp);
/// ODE's first group is that of the axis which its first body carries.
void ode_limit_universal(dJointID, const core::Joint&, bool reversed, std::optional<double> erp);

}  // namespace cylon::simulators
