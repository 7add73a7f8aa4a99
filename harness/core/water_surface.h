// Where the surface of a scene's water stands; the words of Water say how.
#pragma once

#include "harness/core/scene.h"

namespace cylon::core {

/// Height of the surface above or below a point at a time [m].  Cells outside the table of mode "step" are as
/// the nearest one in it.
double water_surface(const Water&, const Vector3& point, double t);

}  // namespace cylon::core
