// What joints do to their bodies, for any method that moves them.
//
// The forces of constraints follow from the state and from what else acts (d'Alembert): with lambda from
// J M^-1 J^T lambda = -(J M^-1 F + J' v) (engine/constraint.h), joint j pulls with the sum of lambda n of its
// rows.  F holds the contacts of the step, each as the constant force that has its impulse.  The impulse over
// a step is the trapezoid of both ends: its error is of second order in dt, first where an impact falls within.
#pragma once

#include "engine/model.h"
#include "engine/stepper.h"

#include <optional>
#include <vector>

namespace cylon::engine {

/// What a joint did to `Joint::body` during a step; to `Joint::to` the opposite, at the same point.
struct Reaction {
  std::size_t joint = 0;              ///< Index in Model::joints.
  Vector3 point = Vector3::Zero();    ///< The anchor on `body` at the end, world axes [m].
  Vector3 impulse = Vector3::Zero();  ///< Of the force, over the step [N s].
  Vector3 moment = Vector3::Zero();   ///< Of the torque beside that of the impulse, over the step [N m s].
};

/// All bodies at an instant.
struct Snapshot {
  Time time = 0;                         ///< [s]
  const std::vector<Motion>* motions{};  ///< One per body of the model.
};

/// Of each joint of a body that moves, from `start` to `end`.  Where joints hold the same twice (a closed
/// loop of hinges), which of them bears what is open: those after take the least.  Nothing where a contact
/// of the step does not tell its impulse, and where joints have limits or dry friction, which do not, or a spring
/// of which the turns count, which two states do not tell.
std::optional<std::vector<Reaction>> reactions(const Model&, const Snapshot& start, const Snapshot& end,
                                               const std::vector<Contact>& contacts);

}  // namespace cylon::engine
