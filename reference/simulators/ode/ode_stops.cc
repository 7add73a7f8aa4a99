#include "reference/simulators/ode/ode_stops.h"

#include "harness/core/joint_coordinates.h"

#include <ode/objects.h>

namespace cylon::simulators {
namespace {

// `set` gives a parameter to the joint.  ODE's coordinate is 0 at the start.
template <class Set>
void limit(core::JointCoordinate c, bool reversed, std::optional<double> erp, const Set& set) {
  if (reversed) core::reverse(c);
  if (c.lower) set(dParamLoStop, *c.lower - c.start);
  if (c.upper) set(dParamHiStop, *c.upper - c.start);
  if (core::has_limit(c)) set(dParamBounce, c.restitution);
  if (core::has_limit(c) && erp) set(dParamStopERP, *erp);
  if (c.friction != 0) set(dParamVel, 0), set(dParamFMax, c.friction);
}

}  // namespace

void ode_limit_hinge(dJointID id, const core::Joint& joint, bool reversed, std::optional<double> erp) {
  for (const core::JointAngle& c : joint.angles)
    limit(c, reversed, erp, [&](int parameter, double value) { dJointSetHingeParam(id, parameter, value); });
}

void ode_limit_slider(dJointID id, const core::Joint& joint, bool reversed, std::optional<double> erp) {
  for (const core::JointDisplacement& c : joint.displacements)
    limit(c, reversed, erp, [&](int parameter, double value) { dJointSetSliderParam(id, parameter, value); });
}

void ode_limit_piston(dJointID id, const core::Joint& joint, bool reversed, std::optional<double> erp) {
  for (const core::JointDisplacement& c : joint.displacements)
    limit(c, reversed, erp, [&](int parameter, double value) { dJointSetPistonParam(id, parameter, value); });
  for (const core::JointAngle& c : joint.angles)
    limit(c, reversed, erp,
          [&](int parameter, double value) { dJointSetPistonParam(id, dParamGroup + parameter, value); });
}

void ode_limit_universal(dJointID id, const core::Joint& joint, bool reversed, std::optional<double> erp) {
  for (const core::JointAngle& c : joint.angles) {
    const bool of_first_body = (c.which == core::Ordinal::second) != reversed;
    const int group = of_first_body ? 0 : dParamGroup;
    limit(c, reversed, erp,
          [&](int parameter, double value) { dJointSetUniversalParam(id, group + parameter, value); });
  }
}

}  // namespace cylon::simulators
