// What the solutions with changing mass share: the thrust of a body and the conditions on it.
#pragma once

#include "harness/core/scene.h"

#include <string_view>

namespace cylon::exact {

/// The body's thrust, or one without effect.
core::Thrust thrust_of(const core::Scene&, std::size_t body);

/// Gravity and at most one thrust per body, no joints, contacts, spin; mass left at the horizon.
void check_variable_mass(std::string_view solution, const core::Scene&, double horizon);

}  // namespace cylon::exact
