// What MuJoCo cannot express, said before its compiler refuses or it resets itself; knows no MuJoCo header.
#pragma once

#include "harness/core/scene.h"

#include <optional>
#include <string>

namespace cylon::simulators {

/// The first reason why MuJoCo cannot run a scene, one sentence; nothing when it can.
std::optional<std::string> mujoco_limit(const core::Scene&);

/// Principal moments A + B >= C as MuJoCo requires them, the largest without what rounding added to it.
core::Vector3 mujoco_moments(const core::Vector3& moments);

}  // namespace cylon::simulators
