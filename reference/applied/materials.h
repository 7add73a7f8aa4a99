// What an adapter says of bodies that may touch without a material.
#pragma once

#include "harness/core/scene.h"
#include "harness/core/surfaces.h"

#include <optional>
#include <string>

namespace cylon::applied {

/// That the scene has no material for a pair.
std::string no_material(const core::Scene&, const core::Pair&);

/// The same of the first such pair, or nothing.
std::optional<std::string> without_material(const core::Scene&);

}  // namespace cylon::applied
