// Small vectors as JSON.
#pragma once

#include "harness/core/scene.h"

#include <nlohmann/json.hpp>

namespace cylon::process {

/// [x, y, z]
inline nlohmann::json vector_json(const core::Vector3& v) { return {v.x(), v.y(), v.z()}; }
/// [w, x, y, z]
inline nlohmann::json quaternion_json(const core::Quaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }

}  // namespace cylon::process
