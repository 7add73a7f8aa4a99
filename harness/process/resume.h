// The same scene from a later state on: how a run is begun anew where something in it was changed.
#pragma once

#include "harness/core/scene.h"
#include "harness/process/joint_hold.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::process {

/// A scene starts at t = 0, and some forces know the time: why this one cannot start from a later state, or
/// nothing where it can.
std::optional<std::string> not_resumable(const core::Scene&);

/// The scene with `state`, at time t [s] of the scene, as its initial state: orientations normalised, masses
/// as they are by then, poses and velocities such as the joints allow, joints where they are now.  `joints`:
/// those of the scene as it was given, so that nothing drifts however often it is begun anew.  Requires a
/// finite state of as many bodies as the scene has, and not_resumable(scene) to be empty or t = 0.
core::Scene resumed(const core::Scene&, const std::vector<core::HeldJoint>& joints, core::State state,
                    double t);

}  // namespace cylon::process
