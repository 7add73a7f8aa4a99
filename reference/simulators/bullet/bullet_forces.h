// The forces that Bullet does not have, evaluated from the state before a step.
#pragma once

#include "harness/core/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::simulators {

/// On one body: force through the centre of mass [N] and torque about it [N m], world axes.
struct Wrench {
  core::Vector3 force = core::Vector3::Zero();
  core::Vector3 torque = core::Vector3::Zero();
};

/// Why a force cannot be expressed, or nothing.
std::optional<std::string> inexpressible(const core::Force&);

/// Sum of the uniform gravity of a scene [m/s^2].
core::Vector3 gravity(const core::Scene&);

/// Whether anything but uniform gravity acts.
bool has_applied_forces(const core::Scene&);

/// Springs, drag, constant thrust, drive and attraction at time t [s]; one wrench per body, overwritten.
void applied_forces(const core::Scene&, const core::State&, double t, std::vector<Wrench>&);

}  // namespace cylon::simulators
