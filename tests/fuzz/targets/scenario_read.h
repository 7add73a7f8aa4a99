// Reads a scenario as the program does, and holds what is taken against the worker's reader.
#pragma once

#include <string>
#include <string_view>

namespace cylon::fuzz {

/// Throws Broken where a refusal has no place, or where a worker reads another scene than was read.
void read_scenario(std::string_view text, const std::string& file_name);

}  // namespace cylon::fuzz
