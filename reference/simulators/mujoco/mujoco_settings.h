// What each path of MuJoCo sets, as words and numbers; knows no MuJoCo header.
#pragma once

#include "harness/core/engine.h"
#include "harness/core/scene_kind.h"
#include "reference/simulators/mujoco/mujoco_options.h"

#include <map>
#include <optional>
#include <string>

namespace cylon::simulators {

/// What the paths and the terms of a run look at in a scene.
struct MujocoKind : core::SceneKind {
  bool rubs = false;     ///< Some pair that may touch has friction.
  bool turns = false;    ///< A body without a fixed axis turns or may be turned.
  bool loops = false;    ///< Some joint is a constraint and no part of the tree.
  bool changes = false;  ///< The mass of some body changes.
};

/// One run's settings of MuJoCo.
struct MujocoSettings {
  std::string path = "as-shipped";   ///< or "as-expert".
  std::string integrator = "euler";  ///< "euler", "implicit" or "rk4".
  MujocoValues values = mujoco_defaults();

  /// Why an option or the integrator is as it is, where a path or the run sets it.
  std::map<std::string, std::string> reasons;

  double at(std::string_view option) const { return values.find(option)->second; }
};

/// What MuJoCo says of itself.
core::Engine mujoco_engine(std::string version);

/// The settings that a setup asks for, on a scene of a kind.
/// Throws std::invalid_argument, naming the nearest valid one, for what mujoco_engine() does not offer.
MujocoSettings mujoco_settings(const core::Engine&, const core::Setup&, const MujocoKind&);

/// The same for the reports.
core::Terms mujoco_terms(const MujocoSettings&, const MujocoKind&);

}  // namespace cylon::simulators
