// What Simbody cannot express, said before it throws; knows no Simbody header.
#pragma once

#include "harness/core/scene.h"

#include <optional>
#include <string>

namespace cylon::simulators {

/// The first reason why Simbody cannot run a scene, one sentence; nothing when it can.
std::optional<std::string> simbody_limit(const core::Scene&);

}  // namespace cylon::simulators
