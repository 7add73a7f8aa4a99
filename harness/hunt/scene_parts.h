// What a scene is made of, and a scene with less of it.
#pragma once

#include "harness/core/scene.h"

#include <cstddef>
#include <set>
#include <string>

namespace cylon::hunt {

/// The kinds of parts of a scene, by the names that files have for them: "box", "gravity", "hinge", "friction".
std::set<std::string> parts(const core::Scene&);

/// The same without the shapes of bodies, which a shrinker makes simpler.
std::set<std::string> parts_without_shapes(const core::Scene&);

/// The scene without a body, and without all that names it.
core::Scene without_body(core::Scene, std::size_t);

}  // namespace cylon::hunt
