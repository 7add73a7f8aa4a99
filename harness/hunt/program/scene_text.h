// The parts of a scene as an engine's rows say them.
#pragma once

#include "harness/core/scene.h"
#include "harness/hunt/program/dialect.h"

#include <string>
#include <vector>

namespace cylon::hunt::program {

/// Why there is no program.
struct None {
  std::string why;
};

/// `takes`: the scene, and what it is restated as, if anything.  All throw None for what no row can say.
void require_expressible(const std::vector<core::Scene>& takes);

/// ${bodies}, ${starts}, ${gravities}, ${friction}, ${restitution}, ${count}, ${shapes}, ${planes}, ${joints}, ${gaps},
/// ${forces} and ${potential}.
void say_scene(const std::vector<core::Scene>& takes, const Dialect&, Words&);

/// ${depths}: of spheres in planes and in each other, and of boxes in planes, by their corners.
std::string depths(const core::Scene&, const Language&);

/// The laws of the forces that the scene has, each once.
std::string laws(const core::Scene&);

}  // namespace cylon::hunt::program
