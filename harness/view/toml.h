// JSON as TOML.  Knows nothing of scenes.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace cylon::view {

/// The document that reads back as the same values in the same order: [key] and [[key]] for the objects and
/// the arrays of objects at the top, everything deeper on one line; an empty array of the top is left out.
/// Every double keeps its bits (inf and nan, but not what a NaN carries); a float never looks like an
/// integer. Throws std::invalid_argument unless it is an object, and at a null, which TOML cannot say.
std::string to_toml(const nlohmann::ordered_json& document);

}  // namespace cylon::view
