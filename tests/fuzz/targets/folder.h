// A folder of this process alone, in memory where the machine has that; it goes with the process.
#pragma once

#include <filesystem>

namespace cylon::fuzz {

const std::filesystem::path& folder();

}  // namespace cylon::fuzz
