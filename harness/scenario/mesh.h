// Wavefront OBJ -> core::Mesh.
#pragma once

#include "harness/core/scene.h"

#include <string>

namespace cylon::scenario {

/// Vertices and triangles of an OBJ file's text; polygons are cut into triangles, materials ignored.
/// Throws std::invalid_argument for text that is no OBJ or that holds no face.
core::Mesh parse_obj(const std::string& text);

}  // namespace cylon::scenario
