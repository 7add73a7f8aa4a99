// What an adapter says of a step, a mass or principal moments that its engine cannot take.
#pragma once

#include "harness/core/engine.h"
#include "harness/core/scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace cylon::applied {

/// That the engine steps forward only, where the step is none.
std::optional<std::string> without_step(std::string_view engine, const core::Setup&);

/// The first body that moves without a mass or a principal moment above zero, or nothing.
std::optional<std::string> without_mass(std::string_view engine, const core::Scene&);

/// The first body that moves with principal moments of no mass distribution, A + B < C by more than 1e-12 of C, or
/// nothing.
std::optional<std::string> without_triangle(std::string_view engine, const core::Scene&);

}  // namespace cylon::applied
