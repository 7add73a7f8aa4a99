// What ODE cannot express, said before it aborts; knows no ODE header.
#pragma once

#include "harness/core/scene.h"

#include <optional>
#include <string>

namespace cylon::simulators {

/// The first reason why ODE cannot run a scene, one sentence; nothing when it can.
std::optional<std::string> ode_limit(const core::Scene&);

}  // namespace cylon::simulators
