// A foreign model as JSON, between the program that holds its library and the harness.
#pragma once

#include "harness/imports/model/model.h"

#include <nlohmann/json.hpp>

namespace cylon::foreign {

nlohmann::json to_json(const Model&);

/// Throws std::runtime_error, or an exception of the library, where it is not what to_json writes.
Model from_json(const nlohmann::json&);

}  // namespace cylon::foreign
