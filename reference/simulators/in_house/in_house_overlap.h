// Bodies that are in one another at t = 0.
#pragma once

#include "engine/diagnostic.h"
#include "engine/model.h"
#include "harness/core/scene.h"

#include <optional>

namespace cylon::simulators {

/// The first pair that may touch, at least one of which moves, and that overlaps at t = 0 deeper than a tenth
/// of the least width of the thinner one; or nothing.  How such bodies would come apart is no
/// question of mechanics; shallower overlaps are taken away, or stay.  Requires the model of the scene.
std::optional<engine::Diagnostic> deep_overlap(const core::Scene&, const engine::Model&);

}  // namespace cylon::simulators
