// What is refused before the TOML library sees it: keys and values nested so deep that its recursion, or that
// of its tables' destructors, could exhaust the stack.
#pragma once

#include <string>
#include <string_view>

namespace cylon::scenario {

/// Dots in one key, and brackets inside each other; a scenario needs 2 and 6.
inline constexpr int deepest_toml = 32;

/// Throws core::InputError at the first dot or bracket that goes deeper.
void require_shallow_toml(std::string_view text, const std::string& file);

}  // namespace cylon::scenario
