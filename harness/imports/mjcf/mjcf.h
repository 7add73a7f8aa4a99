// A compiled model of MuJoCo as a foreign model.  MuJoCo's rules, all of them: which bodies are one, which surfaces
// touch and with what friction, and what acts on a joint.
#pragma once

#include "harness/imports/mjcf/compiled.h"

#include <string>
#include <vector>

namespace cylon::imports {

/// The model, which starts from a keyframe or, "", from its own start.  Throws an exception of the JSON library
/// where it is no such model, and NotFinite.
foreign::Model model_of_mjcf(const Compiled&, const std::string& keyframe = "");

// The parts of that.
std::vector<foreign::Body> bodies_of(const Compiled&, foreign::Model&);
void add_joints(const Compiled&, foreign::Model&);
void add_surfaces(const Compiled&, foreign::Model&);
void add_losses(const Compiled&, const std::string& keyframe, foreign::Model&);

/// What the actuators exert on a joint coordinate q by themselves: Q = force - stiffness q - damping q'.
struct Drive {
  double force = 0, stiffness = 0, damping = 0;
};
/// One per joint; the other actuators are among the losses.
std::vector<Drive> drives_of(const Compiled&, foreign::Model&);

}  // namespace cylon::imports
