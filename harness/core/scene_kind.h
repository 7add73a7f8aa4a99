// What kind of scene a scene is: what the rules look at by which an adapter chooses an engine's settings.
#pragma once

#include "harness/core/scene.h"

namespace cylon::core {

struct SceneKind {
  bool touches = false;   ///< Some pair may touch.
  bool bounces = false;   ///< Some such pair has restitution > 0.
  bool piles = false;     ///< Some such pair is of two moving bodies.
  bool applied = false;   ///< A force acts that is no uniform gravity; in a turning frame one does.
  double mass_ratio = 1;  ///< Of the heaviest moving body to the lightest.

  /// Whether sweeps over the constraints, which carry a share of an impulse from body to body, are too few.
  bool wide() const { return mass_ratio >= 1000; }
};

SceneKind scene_kind(const Scene&);

}  // namespace cylon::core
