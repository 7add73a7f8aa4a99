// The joints of a scene, and what acts along their coordinates, as the in-house engine states them.
#pragma once

#include "engine/model.h"
#include "harness/core/scene.h"

namespace cylon::simulators {

void add_joints(const core::Scene&, engine::Model&);

}  // namespace cylon::simulators
