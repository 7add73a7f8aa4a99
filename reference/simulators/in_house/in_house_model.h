// A scene in the in-house engine's terms.
#pragma once

#include "engine/model.h"
#include "harness/core/scene.h"
#include "reference/simulators/in_house/in_house_plugins.h"

#include <optional>
#include <string>

namespace cylon::simulators {

/// What came of it: a model, or the reason why the engine has no words for the scene.
struct InHouseModel {
  engine::Model model;
  std::optional<std::string> missing;
  std::optional<std::string> lost;  ///< What the model leaves out of the scene, for which a run is refused.
};

/// O(bodies): which surface meets which is told by classes, never pair by pair.
InHouseModel in_house_model(const core::Scene&, const Plugins& = {});

}  // namespace cylon::simulators
