// How far the surfaces of a scene may be from what it says: the stated deviations of friction and restitution.
#pragma once

#include "harness/validation/normal.h"
#include "reference/measured/experiment.h"

#include <algorithm>
#include <vector>

namespace cylon::validation {

/// What the friction and the restitution of each material are more than the scene's, so many deviations of one.
inline std::vector<measured::MaterialError> drawn_surfaces(const measured::Experiment& e, Normal& normal,
                                                           double deviation = 1) {
  std::vector<measured::MaterialError> all(e.model.scene.materials.size());
  for (measured::MaterialError& one : all) {
    one.friction = normal(deviation * e.material.friction);
    one.restitution = normal(deviation * e.material.restitution);
  }
  return all;
}

/// Cut at what is possible.
inline void add_surfaces(core::Scene& scene, const std::vector<measured::MaterialError>& by) {
  for (std::size_t i = 0; i < by.size(); ++i) {
    core::Material& m = scene.materials[i];
    m.friction = std::max(0.0, m.friction + by[i].friction);
    m.restitution = std::clamp(m.restitution + by[i].restitution, 0.0, 1.0);
  }
}

}  // namespace cylon::validation
