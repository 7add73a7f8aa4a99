// Bodies that are in one another at t = 0.
#pragma once

#include "engine/diagnostic.h"
#include "engine/model.h"
#include "harness/core/scene.h"

#include <vector>

namespace cylon::simulators {

/// Pairs that may touch, at least one of which moves, and that overlap at t = 0 deeper than a tenth of the least width of
/// the thinner one.  How such bodies would come apart is no question of mechanics; shallower overlaps are taken away,
/// or stay.  Two that joints hold to each other, if through other bodies, are parts that pass through each other as
/// jointed neighbours do: the model is told that they do not touch.  Requires the model of the scene.
std::vector<engine::Diagnostic> settle_deep_overlaps(const core::Scene&, engine::Model&);

}  // namespace cylon::simulators
