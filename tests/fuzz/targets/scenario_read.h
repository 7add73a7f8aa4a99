// Reads a scenario as the program does, and asks every other part whether it takes what was read.
#pragma once

#include <string>
#include <string_view>

namespace cylon::fuzz {

/// Throws Broken where a refusal has no place, or where a part does not take the scene.
void read_scenario(std::string_view text, const std::string& file_name);

}  // namespace cylon::fuzz
