// Shapes and the small vectors as JSON; see scene_json.h.
#pragma once

#include "harness/core/scene.h"

#include <nlohmann/json.hpp>

#include <string>

namespace cylon::process {

nlohmann::json vector_json(const core::Vector3&);         ///< [x, y, z]
nlohmann::json quaternion_json(const core::Quaternion&);  ///< [w, x, y, z]

/// {"type": "sphere", "radius": …}; null for monostate.
nlohmann::json shape_json(const core::Shape&);

/// Throws MalformedMessage with the key below `place`.
core::Shape shape_from_json(const nlohmann::json&, const std::string& place);

}  // namespace cylon::process
