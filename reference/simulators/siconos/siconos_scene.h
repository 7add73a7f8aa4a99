// A scene as the border to Siconos takes it: bodies that move, and spheres that may touch something.
#pragma once

#include "harness/core/scene.h"
#include "reference/simulators/siconos/border/siconos_world.h"

#include <vector>

namespace cylon::simulators {

struct SiconosScene {
  std::vector<siconos_border::Body> bodies;
  std::vector<int> index;  ///< By body of the scene: among those that move; -1: locked.
  std::vector<siconos_border::Contact> contacts;
  std::vector<core::Pair> pairs;  ///< Of the contacts; the first body moves.
};

/// Requires that siconos_limit(scene) says nothing.
SiconosScene siconos_scene(const core::Scene&);

inline siconos_border::Vector to_siconos(const core::Vector3& v) { return {v.x(), v.y(), v.z()}; }
inline core::Vector3 from_siconos(const siconos_border::Vector& v) { return {v[0], v[1], v[2]}; }

}  // namespace cylon::simulators
