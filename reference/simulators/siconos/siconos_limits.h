// What Siconos cannot express by itself, said before anything is built; knows no Siconos header.
#pragma once

#include "harness/core/scene.h"

#include <optional>
#include <string>

namespace cylon::simulators {

/// The first reason why Siconos cannot run a scene, one sentence; nothing when it can.
std::optional<std::string> siconos_limit(const core::Scene&);

}  // namespace cylon::simulators
