// What is applied to a body.
#pragma once

#include "harness/core/scene.h"

namespace cylon::applied {

/// On one body: force through the centre of mass [N] and torque about it [N m], world axes.
struct Wrench {
  core::Vector3 force = core::Vector3::Zero();
  core::Vector3 torque = core::Vector3::Zero();
};

}  // namespace cylon::applied
