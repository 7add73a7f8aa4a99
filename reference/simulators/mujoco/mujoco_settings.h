// What each path of MuJoCo sets, as words and numbers; knows no MuJoCo header.
#pragma once

#include "harness/core/engine.h"
#include "harness/core/scene_kind.h"
#include "reference/applied/settings.h"

#include <string>

namespace cylon::simulators {

/// What the paths and the terms of a run look at in a scene.
struct MujocoKind : core::SceneKind {
  bool rubs = false;     ///< Some pair that may touch has friction.
  bool turns = false;    ///< A body without a fixed axis turns or may be turned.
  bool loops = false;    ///< Some joint is a constraint and no part of the tree.
  bool changes = false;  ///< The mass of some body changes.
};

/// One run's settings of MuJoCo: "euler", "implicit" or "rk4" on a path.
using MujocoSettings = applied::Settings;

/// Every setting as MuJoCo has it by itself.
MujocoSettings mujoco_as_shipped();

/// What MuJoCo says of itself.
core::Engine mujoco_engine(std::string version);

/// The settings that a setup asks for, on a scene of a kind.
/// Throws std::invalid_argument, naming the nearest valid one, for what mujoco_engine() does not offer.
MujocoSettings mujoco_settings(const core::Engine&, const core::Setup&, const MujocoKind&);

/// The same for the reports.
core::Terms mujoco_terms(const MujocoSettings&, const MujocoKind&);

}  // namespace cylon::simulators
