// The shapes of a scene as ODE's geoms.
#pragma once

#include "harness/core/scene.h"

struct dxBody;   // ODE's body
struct dxSpace;  // and its space of geoms

namespace cylon::simulators {

/// Adds a body's primitives to the space: fixed to ODE's body, or at rest in the world where that is null.
/// Each carries `owner` as its data.  Shapes that ODE lacks are left out.
void ode_add_shape(dxSpace*, const core::Body&, dxBody*, void* owner);

/// Whether two moving bodies touch each other at the start, or would if each were larger by a millionth.
bool ode_stacked(const core::Scene&);

}  // namespace cylon::simulators
