// What DART cannot express, said before it is silent about it; knows no DART header.
#pragma once

#include "harness/core/scene.h"

#include <optional>
#include <string>

namespace cylon::simulators {

/// The first reason why DART cannot run a scene, one sentence; nothing when it can.
std::optional<std::string> dart_limit(const core::Scene&);

}  // namespace cylon::simulators
