// What of a scene may be changed while it runs, by key: a table.
#pragma once

#include "harness/core/scene.h"

#include <string_view>
#include <variant>

namespace cylon::view {

/// Changes one number or vector of the scene:
///   gravity                                     a vector
///   spring.I.stiffness rest_length damping      I: index in the list of that kind, as workers get it
///   drag.I.linear angular momentum
///   attraction.I.strength
///   water.I.level buoyancy drag
///   material.I.restitution friction
///   body.NAME.mass                              the inertia goes with it: the same body of another density
/// Throws BadCommand, and leaves the scene as it was, for a key that is none, an index out of range, a number
/// where a vector belongs, or a value outside the domain of the scenario format.
void set_parameter(core::Scene&, std::string_view key, const std::variant<double, core::Vector3>& value);

}  // namespace cylon::view
