// How large a body is.
#pragma once

#include "harness/core/scene.h"

namespace cylon::core {

/// Distance of the farthest point from the centre of mass; without a surface the radius of gyration sqrt(I/m)
/// about the axis of the largest moment [m].
double size(const Body&);

}  // namespace cylon::core
