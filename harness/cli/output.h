// Files written whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace cylon::cli {

/// Writes to a file beside `path` and renames it, so that a reader never sees half of it; "-" is stdout.
/// Throws core::InputError where that cannot be.
void write_whole(const std::string& path, std::string_view text);

/// Throws core::InputError now where write_whole could not write later: a missing folder, a directory in the way.
void require_writable(const std::string& path);

}  // namespace cylon::cli
