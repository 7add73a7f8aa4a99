// Files that the viewer writes under names that others can guess: whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace cylon::view {

/// Writes a file beside `path` and renames it, so that nobody sees half of it, and a link of that name is replaced and
/// not followed.  Throws core::InputError where that cannot be; nothing is left then.
void write_whole_file(const std::filesystem::path&, std::string_view bytes);

}  // namespace cylon::view
