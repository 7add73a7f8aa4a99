// Shapes in the in-house engine's terms.
#pragma once

#include "engine/shape.h"
#include "harness/core/scene.h"

#include <string>
#include <variant>

namespace cylon::simulators {

using Missing = std::string;  ///< What the engine has no shape for: "a disc", "a mesh that is not convex".

/// The shape, or what is missing.  A mesh that is convex is its hull, another one the triangles of its surface, which
/// a body has that never moves; a rod is a capsule without thickness.
std::variant<engine::Shape, Missing> in_house_shape(const core::Shape&, bool locked);

}  // namespace cylon::simulators
